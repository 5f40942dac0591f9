//! Text and numbers to the emulator's standard output. What cannot be written is lost: there is nobody to tell.

use cortex_m_semihosting::hio;

/// Digits of the largest number.
const DIGITS: usize = 20;

/// Writes `text`.
pub fn text(text: &str) {
    bytes(text.as_bytes());
}

/// Writes a number in decimal digits.
pub fn decimal(mut number: u32) {
    let mut digits = [b'0'; DIGITS];
    let mut count = 0;
    for digit in digits.iter_mut().rev() {
        *digit = b'0'.wrapping_add((number % 10) as u8);
        number /= 10;
        count += 1;
        if number == 0 {
            break;
        }
    }
    bytes(digits.get(DIGITS.saturating_sub(count)..).unwrap_or(&[]));
}

/// Writes a word in sixteen hexadecimal digits.
pub fn hexadecimal(mut word: u64) {
    let mut digits = [b'0'; 16];
    for digit in digits.iter_mut().rev() {
        let value = (word & 15) as u8;
        *digit =
            if value < 10 { b'0'.wrapping_add(value) } else { b'a'.wrapping_add(value.wrapping_sub(10)) };
        word >>= 4;
    }
    bytes(&digits);
}

fn bytes(bytes: &[u8]) {
    if let Ok(mut output) = hio::hstdout() {
        let _ = output.write_all(bytes);
    }
}
