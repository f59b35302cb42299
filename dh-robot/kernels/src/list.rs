//! A list of fixed capacity on the stack: what every kernel returns its solutions in.

use core::ops::Deref;

/// A value for the unused places of a list. (`Default` isn't there for arrays of any length.)
pub trait Blank: Copy {
    /// That value.
    const BLANK: Self;
}

impl Blank for f64 {
    const BLANK: Self = 0.0;
}

impl Blank for bool {
    const BLANK: Self = false;
}

impl<T: Blank, const N: usize> Blank for [T; N] {
    const BLANK: Self = [T::BLANK; N];
}

impl<A: Blank, B: Blank> Blank for (A, B) {
    const BLANK: Self = (A::BLANK, B::BLANK);
}

/// At most `N` values; derefs to a slice.
#[derive(Clone, Copy, Debug)]
pub struct List<T, const N: usize> {
    items: [T; N],
    len: usize,
}

impl<T: Blank, const N: usize> List<T, N> {
    /// An empty list.
    #[inline]
    pub fn new() -> Self {
        Self { items: [T::BLANK; N], len: 0 }
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

    /// The values, to be changed.
    #[inline]
    pub fn iter_mut(&mut self) -> core::slice::IterMut<'_, T> {
        self.items.get_mut(..self.len).unwrap_or(&mut []).iter_mut()
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

impl<T: Blank, const N: usize> Default for List<T, N> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T: Blank, const N: usize> Deref for List<T, N> {
    type Target = [T];
    #[inline]
    fn deref(&self) -> &[T] {
        self.as_slice()
    }
}

impl<'a, T: Blank, const N: usize> IntoIterator for &'a List<T, N> {
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
        let mut list = List::<f64, 2>::new();
        assert!(list.push(1.0) && list.push(2.0) && !list.push(3.0));
        assert_eq!(list.as_slice(), &[1.0, 2.0]);
        assert_eq!((list.pop(), list.pop(), list.pop()), (Some(2.0), Some(1.0), None));
        assert!(list.is_empty());
    }
}
