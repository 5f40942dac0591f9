//! The most stack that a function can take, from its machine code (Thumb-2): the frames along the deepest way of calls.
//!
//! Every instruction that moves the stack pointer down counts, whether it is reached or not, and every call. A call through
//! a register may reach every function whose address stands in a table or is made in the code. A recursion, or a frame whose
//! size is not a constant, is an error: then there is no bound.
//!
//! Encodings: ARMv7-M Architecture Reference Manual (DDI 0403E), A7.

use std::collections::BTreeMap;

use anyhow::{Context, Result, bail};

use super::elf::{Function, Program};

/// What one function does to the stack.
#[derive(Debug, Default, PartialEq, Eq)]
struct Frame {
    bytes: u64,
    calls: Vec<u32>,
    /// Whether it calls through a register.
    is_indirect: bool,
    /// Addresses that it makes of constants.
    made: Vec<u32>,
}

/// What is known while a bound is found.
struct Search<'a> {
    program: &'a Program,
    /// The depth of each function, by address.
    known: BTreeMap<u32, u64>,
    /// Where calls through registers can lead.
    addressed: Vec<u32>,
}

/// The bound for `function` and all that it calls. Units: bytes.
pub fn bound(program: &Program, function: &Function) -> Result<u64> {
    let mut addressed: Vec<u32> = program.addressed().iter().map(|function| function.address).collect();
    for one in &program.functions {
        // what cannot be read here is an error where it is called
        let made = frame(program, one).map(|frame| frame.made).unwrap_or_default();
        let starts =
            |address: &u32| program.functions.iter().any(|function| function.address | 1 == *address);
        addressed.extend(made.iter().filter(|address| starts(address)).map(|address| address & !1));
    }
    addressed.sort_unstable();
    addressed.dedup();
    Search { program, known: BTreeMap::new(), addressed }.depth(function, &mut Vec::new())
}

impl Search<'_> {
    fn depth(&mut self, function: &Function, way: &mut Vec<u32>) -> Result<u64> {
        if let Some(depth) = self.known.get(&function.address) {
            return Ok(*depth);
        }
        if way.contains(&function.address) {
            bail!("{} may call itself", function.name);
        }
        way.push(function.address);
        let mut frame = frame(self.program, function).with_context(|| function.name.clone())?;
        if frame.is_indirect {
            frame.calls.extend(&self.addressed);
        }
        let mut deepest = 0;
        for target in frame.calls {
            let called = self
                .program
                .function_at(target)
                .with_context(|| format!("{} calls {target:#x}, where no function is", function.name))?;
            // a jump back into the caller itself is a loop
            if called.address != function.address || target == function.address {
                deepest = deepest.max(self.depth(called, way)?);
            }
        }
        way.pop();
        self.known.insert(function.address, frame.bytes + deepest);
        Ok(frame.bytes + deepest)
    }
}

fn frame(program: &Program, function: &Function) -> Result<Frame> {
    let end = function.address + function.size;
    let mut frame = Frame::default();
    let mut constants = [None::<u32>; 16];
    let mut address = function.address;
    while address < end {
        if is_data(program, address) {
            address += 2;
            continue;
        }
        let first = program.halfword(address).context("the code is cut short")?;
        let wide = first >> 11 >= 0b11101;
        let second = if wide { program.halfword(address + 2).context("the code is cut short")? } else { 0 };
        let step = if wide {
            wide_instruction(first, second, address, &mut constants)
        } else {
            narrow_instruction(first, address)
        };
        match step {
            Step::Nothing => {}
            Step::Push(bytes) => frame.bytes += u64::from(bytes),
            Step::Call(target) => frame.calls.push(target),
            Step::Jump(target) if (function.address..end).contains(&target) => {}
            Step::Jump(target) => frame.calls.push(target),
            Step::Indirect => frame.is_indirect = true,
            Step::Made(word) => frame.made.push(word),
            Step::Unknown(what) => bail!("{what} at {address:#x}: no bound of the stack"),
        }
        address += if wide { 4 } else { 2 };
    }
    Ok(frame)
}

fn is_data(program: &Program, address: u32) -> bool {
    let place = program.data_begins.partition_point(|(begin, _)| *begin <= address);
    place.checked_sub(1).and_then(|place| program.data_begins.get(place)).is_some_and(|(_, data)| *data)
}

#[derive(Debug, PartialEq, Eq)]
enum Step {
    Nothing,
    Push(u32),
    Call(u32),
    Jump(u32),
    /// A call or a jump through a register.
    Indirect,
    /// A word made of two constants, which may be an address.
    Made(u32),
    Unknown(&'static str),
}

/// What aligning the stack pointer to more than eight bytes can take at most, for frames with such variables.
const ALIGNMENT: u32 = 64;

fn narrow_instruction(first: u16, address: u32) -> Step {
    let w = u32::from(first);
    let pc = address.wrapping_add(4);
    if w & 0xfe00 == 0xb400 {
        return Step::Push(4 * ((w & 0xff).count_ones() + (w >> 8 & 1)));
    }
    if w & 0xff80 == 0xb080 {
        return Step::Push(4 * (w & 0x7f));
    }
    if w & 0xff87 == 0x4780 {
        return Step::Indirect;
    }
    // bx, other than to the return address
    if w & 0xff87 == 0x4700 && w >> 3 & 15 != 14 {
        return Step::Indirect;
    }
    // mov sp, rm; from r7 it takes a frame away
    if w & 0xff87 == 0x4685 {
        return if w >> 3 & 15 == 7 { Step::Nothing } else { Step::Push(ALIGNMENT) };
    }
    if w & 0xf800 == 0xe000 {
        return Step::Jump(pc.wrapping_add(signed(w & 0x7ff, 11) << 1));
    }
    if w & 0xf000 == 0xd000 && w >> 8 & 15 < 14 {
        return Step::Jump(pc.wrapping_add(signed(w & 0xff, 8) << 1));
    }
    Step::Nothing
}

fn wide_instruction(first: u16, second: u16, address: u32, constants: &mut [Option<u32>; 16]) -> Step {
    let (a, b) = (u32::from(first), u32::from(second));
    let pc = address.wrapping_add(4);
    let immediate = (a >> 10 & 1) << 11 | (b >> 12 & 7) << 8 | b & 0xff;
    let to = (b >> 8 & 15) as usize;
    if a & 0xf800 == 0xf000 && b & 0x8000 != 0 {
        let (s, j1, j2) = (a >> 10 & 1, b >> 13 & 1, b >> 11 & 1);
        let long = {
            let (i1, i2) = (1 ^ j1 ^ s, 1 ^ j2 ^ s);
            signed(s << 23 | i1 << 22 | i2 << 21 | (a & 0x3ff) << 11 | b & 0x7ff, 24) << 1
        };
        return match b & 0xd000 {
            0xd000 => Step::Call(pc.wrapping_add(long)),
            0x9000 => Step::Jump(pc.wrapping_add(long)),
            0x8000 if a >> 6 & 15 < 14 => {
                let short = signed(s << 19 | j2 << 18 | j1 << 17 | (a & 0x3f) << 11 | b & 0x7ff, 20) << 1;
                Step::Jump(pc.wrapping_add(short))
            }
            _ => Step::Nothing,
        };
    }
    match a {
        // stmdb sp!, str [sp, #-4]!, strd [sp, #-n]!
        0xe92d => return Step::Push(4 * b.count_ones()),
        0xf84d if b & 0x0f00 == 0x0d00 => return Step::Push(b & 0xff),
        0xe96d => return Step::Push(4 * (b & 0xff)),
        _ => {}
    }
    // vpush
    if a & 0xffbf == 0xed2d && b & 0x0e00 == 0x0a00 {
        return Step::Push(4 * (b & 0xff));
    }
    // movw, movt: constants that a frame may be made of
    if a & 0xfbf0 == 0xf240 {
        constants[to] = Some((a & 15) << 12 | immediate);
        return Step::Nothing;
    }
    if a & 0xfbf0 == 0xf2c0 {
        constants[to] = constants[to].map(|low| ((a & 15) << 12 | immediate) << 16 | low & 0xffff);
        return constants[to].map_or(Step::Nothing, Step::Made);
    }
    if to == 13 {
        // sub sp, sp, #constant in its two forms, and sub sp, sp, rm
        if a & 0xfbef == 0xf1ad {
            return Step::Push(expanded(immediate));
        }
        if a & 0xfbff == 0xf2ad {
            return Step::Push(immediate);
        }
        if a & 0xffef == 0xebad {
            return constants[(b & 15) as usize].map_or(Step::Unknown("a frame of unknown size"), Step::Push);
        }
    }
    Step::Nothing
}

/// `value` of so many bits with its sign.
fn signed(value: u32, bits: u32) -> u32 {
    ((value << (32 - bits)) as i32 >> (32 - bits)) as u32
}

/// ThumbExpandImm: a byte, repeated or rotated.
fn expanded(immediate: u32) -> u32 {
    let byte = immediate & 0xff;
    if immediate >> 10 & 3 != 0 {
        return (0x80 | immediate & 0x7f).rotate_right(immediate >> 7 & 31);
    }
    match immediate >> 8 & 3 {
        0 => byte,
        1 => byte << 16 | byte,
        2 => byte << 24 | byte << 8,
        _ => byte.wrapping_mul(0x0101_0101),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wide(first: u16, second: u16) -> Step {
        wide_instruction(first, second, 0x1000, &mut [None; 16])
    }

    /// As `arm-none-eabi-as` encodes them.
    #[test]
    fn instructions_that_move_the_stack_pointer_are_known() {
        assert_eq!(narrow_instruction(0xb5f0, 0), Step::Push(20)); // push {r4-r7, lr}
        assert_eq!(narrow_instruction(0xb082, 0), Step::Push(8)); // sub sp, #8
        assert_eq!(wide(0xe92d, 0x4ff0), Step::Push(36)); // push {r4-r11, lr}
        assert_eq!(wide(0xf84d, 0x4d04), Step::Push(4)); // push {r4}
        assert_eq!(wide(0xed2d, 0x8b10), Step::Push(64)); // vpush {d8-d15}
        assert_eq!(wide(0xed2d, 0x8a10), Step::Push(64)); // vpush {s16-s31}
        assert_eq!(wide(0xf5ad, 0x6d80), Step::Push(1024)); // sub.w sp, sp, #1024
        assert_eq!(wide(0xf2ad, 0x4d04), Step::Push(1028)); // subw sp, sp, #1028
        assert_eq!(wide(0xebad, 0x0d03), Step::Unknown("a frame of unknown size")); // sub.w sp, sp, r3
    }

    #[test]
    fn calls_and_jumps_go_where_they_go() {
        assert_eq!(wide(0xf000, 0xf800), Step::Call(0x1004)); // bl .+4
        assert_eq!(wide(0xf7ff, 0xfffe), Step::Call(0x1000)); // bl .
        assert_eq!(wide(0xf7ff, 0xbffe), Step::Jump(0x1000)); // b.w .
        assert_eq!(narrow_instruction(0xe7fe, 0x1000), Step::Jump(0x1000)); // b .
        assert_eq!(narrow_instruction(0x4770, 0), Step::Nothing); // bx lr
        assert_eq!(narrow_instruction(0x4798, 0), Step::Indirect); // blx r3
        assert_eq!(narrow_instruction(0x4718, 0), Step::Indirect); // bx r3
    }

    #[test]
    fn constants_are_expanded() {
        assert_eq!(expanded(0x0ff), 0xff);
        assert_eq!(expanded(0x3ab), 0xabab_abab);
        assert_eq!(expanded(0xe80), 1024);
        assert_eq!(expanded(0x1ab), 0x00ab_00ab);
    }
}
