//! Whole numbers as digits of a program.

/// Appends a whole number. Programs have millions of numbers: this costs a third of the standard formatting.
pub(super) fn push_whole(text: &mut String, number: u32) {
    let mut digits = [b'0'; 10];
    let mut at = digits.len();
    let mut rest = number;
    loop {
        at -= 1;
        digits[at] = digit(rest % 10);
        rest /= 10;
        if rest == 0 {
            break;
        }
    }
    text.extend(digits[at..].iter().map(|&digit| char::from(digit)));
}

/// The last digit of a number.
pub(super) fn digit(value: u32) -> u8 {
    b"0123456789"[(value % 10) as usize]
}
