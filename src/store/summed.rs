//! The SHA-256 of what is read, taken while it is read.

use std::cell::RefCell;
use std::io::{self, BufRead, Read, Seek, SeekFrom};
use std::rc::Rc;

use sha2::{Digest, Sha256};

use super::draft::{hexadecimal, sum_into};

/// Where the sum of a file is found once its reader is gone; nothing where the file could not be read to its end.
pub type Sum = Rc<RefCell<Option<String>>>;

/// A file that is read in any order, whatever of it; the sum is that of all its bytes.
#[derive(Debug)]
pub struct Summed<R: BufRead + Seek> {
    inner: R,
    digest: Sha256,
    /// The bytes from the beginning that the digest has.
    taken: u64,
    /// Where the reader stands.
    at: u64,
    sum: Sum,
}

impl<R: BufRead + Seek> Summed<R> {
    /// Of a reader that stands at its beginning.
    pub fn new(inner: R, sum: &Sum) -> Self {
        Self { inner, digest: Sha256::new(), taken: 0, at: 0, sum: Rc::clone(sum) }
    }
}

impl<R: BufRead + Seek> Read for Summed<R> {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        let read = self.fill_buf()?.read(into)?;
        self.consume(read);
        Ok(read)
    }
}

impl<R: BufRead + Seek> BufRead for Summed<R> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        self.inner.fill_buf()
    }

    fn consume(&mut self, amount: usize) {
        let end = self.at.saturating_add(u64::try_from(amount).unwrap_or(u64::MAX));
        // What is passed over for the first time is taken, wherever the reading began.
        if self.at <= self.taken && self.taken < end {
            let before = usize::try_from(self.taken - self.at).unwrap_or(usize::MAX);
            if let Some(new) = self.inner.fill_buf().ok().and_then(|buffer| buffer.get(before..amount)) {
                self.digest.update(new);
                self.taken = end;
            }
        }
        self.inner.consume(amount);
        self.at = end;
    }
}

impl<R: BufRead + Seek> Seek for Summed<R> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.at = self.inner.seek(to)?;
        Ok(self.at)
    }
}

impl<R: BufRead + Seek> Drop for Summed<R> {
    fn drop(&mut self) {
        let rest =
            self.inner.seek(SeekFrom::Start(self.taken)).and_then(|_| sum_into(&mut self.digest, &mut self.inner));
        if rest.is_ok() {
            *self.sum.borrow_mut() = Some(hexadecimal(&std::mem::take(&mut self.digest).finalize()));
        }
    }
}

#[cfg(test)]
mod tests {
    use std::io::{BufReader, Cursor};

    use super::*;
    use crate::store::sha256;

    #[test]
    fn the_sum_is_that_of_the_whole_file_however_it_was_read() {
        let bytes: Vec<u8> = (0..=250).cycle().take(10_000).collect();
        let reads: [&[(u64, usize)]; 5] =
            [&[], &[(0, 10_000)], &[(0, 100), (0, 300), (50, 7000)], &[(9000, 1000), (10, 20)], &[(0, 40), (40, 1)]];
        for places in reads {
            let sum = Sum::default();
            let mut reader = Summed::new(BufReader::with_capacity(64, Cursor::new(&bytes)), &sum);
            for &(from, count) in places {
                reader.seek(SeekFrom::Start(from)).expect("a place");
                let mut into = vec![0; count];
                reader.read_exact(&mut into).expect("bytes");
                let from = usize::try_from(from).expect("a place");
                assert_eq!(into, bytes[from..from + count]);
            }
            drop(reader);
            assert_eq!(sum.borrow().as_deref(), Some(sha256(&bytes).as_str()), "{places:?}");
        }
    }
}
