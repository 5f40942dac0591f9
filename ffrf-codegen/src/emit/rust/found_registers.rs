//! Statements that run in the registers of the processor at hand, found when running.

use crate::emit::writer::Writer;

/// Writes statements, in which `registers` are those that are found when running if `finds_registers`.
pub(super) fn on_registers(writer: &mut Writer, finds_registers: bool, write: impl FnOnce(&mut Writer)) {
    if finds_registers {
        writer.block("support::lanes::on_registers!(registers => {", "})", write);
    } else {
        write(writer);
    }
}
