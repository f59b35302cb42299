//! Names that C, C++, CMake and Cargo can have: of the library, which begins all of C's names, and of fields.

/// Words that mean something to C, C++ or Rust, separated by spaces.
const WORDS: &str = "\
    alignas alignof and and_eq as asm async auto await bitand bitor bool box break case catch char char16_t \
    char32_t char8_t class co_await co_return co_yield compl concept const const_cast consteval constexpr \
    constinit continue crate decltype default delete do double dyn dynamic_cast else enum explicit export extern \
    false final float fn for friend gen goto i386 if impl import in inline int int16_t int32_t int64_t int8_t let \
    linux long loop macro match mod module move mut mutable namespace new noexcept not not_eq nullptr operator or \
    or_eq override private protected ptrdiff_t pub public ref register reinterpret_cast requires restrict return \
    self short signed size_t sizeof static static_assert static_cast struct super switch template this \
    thread_local throw trait true try type typedef typeid typename typeof uint16_t uint32_t uint64_t uint8_t union \
    unix unsafe unsigned unsized use using virtual void volatile wchar_t where while xor xor_eq yield";

/// Libraries of these names are others, or the crate's own dependencies, or mean something to C++ or Cargo.
const TAKEN: &str = "\
    alloc build c core deps dh_kernels dh_macro dh_robot dl examples gcc_s incremental m nalgebra proc_macro \
    pthread rt std test util";

/// Whether C or C++ has another meaning for it.
fn is_word(name: &str) -> bool {
    WORDS.split(' ').any(|word| word == name)
}

/// The library's name for a type: `puma560` for `Puma560`, `kuka_kr6_r700` for `KukaKr6R700`.
pub fn default_name(name: &str) -> String {
    let letters: Vec<char> = name.chars().collect();
    let mut out = String::new();
    for (i, c) in letters.iter().enumerate() {
        let before = i.checked_sub(1).and_then(|i| letters.get(i));
        let after = letters.get(i + 1);
        let begins = before.is_some_and(|b| b.is_lowercase() || b.is_ascii_digit())
            || before.is_some_and(|b| b.is_uppercase()) && after.is_some_and(|a| a.is_lowercase());
        if c.is_uppercase() && begins {
            out.push('_');
        }
        out.extend(c.to_lowercase());
    }
    let parts: Vec<&str> = out.split('_').filter(|part| !part.is_empty()).collect();
    parts.join("_")
}

/// Whether a library can have this name.
///
/// # Errors
/// What is wrong with it.
pub fn fit(name: &str) -> Result<(), String> {
    let letters = name.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'_');
    if !letters || !name.starts_with(|c: char| c.is_ascii_lowercase()) || name.contains("__") || name.len() > 60 {
        return Err(format!("a library of C cannot be called `{name}`: small letters, digits and single underscores"));
    }
    if is_word(name) || TAKEN.split(' ').any(|word| word == name) {
        return Err(format!("a library of C cannot be called `{name}`: the name has another meaning"));
    }
    Ok(())
}

/// The fields of a struct in C: their names, with an underscore where C or C++ has another meaning for one.
pub(super) fn fields(names: &[String]) -> Vec<String> {
    let mut out: Vec<String> = Vec::new();
    for name in names {
        let mut own = name.clone();
        while is_word(&own)
            || matches!(own.as_str(), "NULL" | "I")
            || out.contains(&own)
            || names.contains(&own) && own != *name
        {
            own.push('_');
        }
        out.push(own);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn types_become_names_of_libraries() {
        for (name, library) in [
            ("Puma560", "puma560"),
            ("KukaKr6R700", "kuka_kr6_r700"),
            ("URDFArm", "urdf_arm"),
            ("Ur5", "ur5"),
            ("arm_2", "arm_2"),
            ("_Arm__", "arm"),
            ("Planar2r", "planar2r"),
        ] {
            assert_eq!(default_name(name), library);
            assert_eq!(fit(library), Ok(()));
        }
        for bad in ["", "2r", "Arm", "größe", "a__b", "double", "m", "std", "a-b", "a b", "fn"] {
            assert!(fit(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn fields_are_no_words_and_differ() {
        let names = ["a2", "long", "long_", "NULL"].map(String::from);
        assert_eq!(fields(&names), ["a2", "long__", "long_", "NULL_"]);
    }
}
