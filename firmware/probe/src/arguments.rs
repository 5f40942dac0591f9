//! What the emulator's command line asks for: `-semihosting-config ...,arg=NAME,arg=WORD,...`.

use crate::machine;

/// The longest command line.
const LENGTH: usize = 512;

/// The words of the command line.
pub struct Arguments {
    text: [u8; LENGTH],
    length: usize,
}

impl Arguments {
    /// Asks the emulator.
    pub fn read() -> Self {
        let mut text = [0; LENGTH];
        let length = machine::command_line(&mut text);
        Self { text, length }
    }

    /// The words after the program's name.
    pub fn words(&self) -> impl Iterator<Item = &str> + Clone {
        let text = self.text.get(..self.length).unwrap_or(&[]);
        text.split(|byte| *byte == b' ' || *byte == 0)
            .filter(|word| !word.is_empty())
            .skip(1)
            .filter_map(|word| core::str::from_utf8(word).ok())
    }
}

/// The number that `word` is, if it is one.
pub fn number(word: &str) -> Option<u32> {
    let mut value = 0_u32;
    for digit in word.bytes() {
        let digit = digit.checked_sub(b'0').filter(|digit| *digit < 10)?;
        value = value.checked_mul(10)?.checked_add(u32::from(digit))?;
    }
    (!word.is_empty()).then_some(value)
}
