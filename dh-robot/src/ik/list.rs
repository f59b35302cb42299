//! A list of fixed capacity on the stack: what every kernel returns its solutions in.

use core::ops::Deref;

/// At most `N` values; derefs to a slice.
#[derive(Clone, Copy, Debug)]
pub struct List<T, const N: usize> {
    items: [T; N],
    len: usize,
}

impl<T: Copy + Default, const N: usize> List<T, N> {
    /// An empty list.
    #[inline]
    pub fn new() -> Self {
        Self { items: [T::default(); N], len: 0 }
    }

    /// Appends a value; a full list stays as it is and answers `false`.
    #[inline]
    pub fn push(&mut self, value: T) -> bool {
        match self.items.get_mut(self.len) {
            Some(slot) => {
                *slot = value;
                self.len += 1;
                true
            }
            None => false,
        }
    }

    /// The values.
    #[inline]
    pub fn as_slice(&self) -> &[T] {
        // `len <= N` always holds, so the fallback is never taken; it keeps the compiler from emitting a panic.
        self.items.get(..self.len).unwrap_or(&[])
    }

    /// The values, to be changed in place.
    #[inline]
    pub fn as_mut_slice(&mut self) -> &mut [T] {
        self.items.get_mut(..self.len).unwrap_or(&mut [])
    }

    /// Takes the last value off.
    #[inline]
    pub fn pop(&mut self) -> Option<T> {
        self.len = self.len.checked_sub(1)?;
        self.items.get(self.len).copied()
    }

    /// Forgets all values.
    #[inline]
    pub fn clear(&mut self) {
        self.len = 0;
    }
}

impl<T: Copy + Default, const N: usize> Default for List<T, N> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T: Copy + Default, const N: usize> Deref for List<T, N> {
    type Target = [T];
    #[inline]
    fn deref(&self) -> &[T] {
        self.as_slice()
    }
}

impl<'a, T: Copy + Default, const N: usize> IntoIterator for &'a List<T, N> {
    type Item = &'a T;
    type IntoIter = core::slice::Iter<'a, T>;
    fn into_iter(self) -> Self::IntoIter {
        self.as_slice().iter()
    }
}

#[cfg(test)]
mod tests {
    use super::List;

    #[test]
    fn a_full_list_refuses() {
        let mut list = List::<u8, 2>::new();
        assert!(list.push(1) && list.push(2) && !list.push(3));
        assert_eq!(list.as_slice(), &[1, 2]);
        assert_eq!((list.pop(), list.pop(), list.pop()), (Some(2), Some(1), None));
        assert!(list.is_empty());
    }
}
