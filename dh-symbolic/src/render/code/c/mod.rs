//! C and C++ interfaces of a robot: a folder that stands alone, with a small Rust crate, headers, a CMake package and examples.
//!
//! **In:** a chain and its inverse, what was written around the table. **Out:** files as text. Solving stays in Rust: the crate holds the
//! table in a call of `dh_robot!`, and a border file whose functions read C's arrays, call the generated ones and write C's arrays.
//!
//! `interface` holds the names and types, `functions` lists what is computed, with its parameters, once; `border` prints them as Rust, `header` as C, `cpp` as C++.

mod border;
mod cpp;
mod functions;
mod header;
mod interface;
mod names;
mod package;

pub use interface::{Interface, Written};
pub use names::{default_name, fit};

/// How the crate finds `dh-robot`, and what the library is called.
#[derive(Clone, Debug)]
pub struct Crate<'a> {
    /// The table: what stands between the braces of `dh_robot!`.
    pub table: &'a str,
    /// The version of `dh-robot`.
    pub version: &'a str,
    /// The folder of `dh-robot`, in place of the registry's.
    pub path: Option<&'a str>,
}

/// All files of the folder, by their paths in it.
pub fn files(interface: &Interface<'_>, own: &Crate<'_>) -> Vec<(String, String)> {
    let name = &interface.name;
    let mut files = vec![
        ("src/c.rs".to_string(), border::text(interface)),
        (format!("include/{name}.h"), header::text(interface)),
        (format!("include/{name}.hpp"), cpp::text(interface)),
    ];
    files.extend(package::files(interface, own));
    files.sort();
    files
}
