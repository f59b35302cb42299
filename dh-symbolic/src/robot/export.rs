//! C and C++ interfaces of a robot, as the files of a folder that stands alone.

use super::{Robot, TableError};
use crate::diagnostic::{Error, Errors};
use crate::pipeline;
use crate::render::code::c;

/// What [`Robot::export_c`] may be told.
#[derive(Clone, Debug, Default)]
pub struct ExportOptions {
    /// The name of the library, which begins the names of all functions and types of C; by default that of the table in small letters:
    /// `puma560` for `Puma560`.
    pub name: Option<String>,
    /// The folder of the crate `dh-robot`, for those who have its source; by default cargo takes it from the registry.
    pub dh_robot: Option<String>,
}

impl Robot {
    /// A C and a C++ interface (C99, C++17) to the code that `dh_robot!` makes of the table: a folder with a small Rust crate, headers, a
    /// CMake package and example programs. Returns each file's path in the folder, with `/`, and its text, in the order of the paths.
    ///
    /// ```
    /// use dh_symbolic::ExportOptions;
    /// # let puma = dh_symbolic::Robot::parse(include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/puma560.dh")))?;
    /// let files = puma.export_c(&ExportOptions::default())?;
    /// let header = &files.iter().find(|file| file.0 == "include/puma560.h").expect("a header").1;
    /// assert!(header.contains("int puma560_forward(const double q[6], double pose[16]);"));
    /// # Ok::<(), dh_symbolic::TableError>(())
    /// ```
    ///
    /// # Errors
    /// Those of the macro (wrong lines of `prove { }` blocks, and why there is no inverse), and a name that a library of C cannot have.
    pub fn export_c(&self, options: &ExportOptions) -> Result<Vec<(String, String)>, TableError> {
        let parsed = self.source.parse()?;
        let (chain, programs) = pipeline::derive(&parsed).map_err(|errors| self.source.error(&errors))?;
        if let Some(pose) = chain.poses.iter().find(|p| p.nominal.is_none()) {
            let error =
                Error::new(parsed.origins.name, format!("`{}` has no nominal value, which is what C gets", pose.name));
            let error = error.help(format!("write `let {}: pose = VALUE;`", pose.name));
            return Err(self.source.error(&Errors::from(error)));
        }
        let name = options.name.clone().unwrap_or_else(|| c::default_name(&chain.name));
        c::fit(&name).map_err(|message| {
            let error = Error::new(parsed.origins.name, message).help("`--name` gives the library another name");
            self.source.error(&Errors::from(error))
        })?;
        let written = c::Written {
            docs: &parsed.head.docs,
            table: &parsed.sketch.table,
            motions: &parsed.sketch.motions,
            fields: parsed.sketch.fields.iter().map(|f| (f.name.to_string(), f.docs.clone())).collect(),
        };
        let interface = c::Interface::new(&chain, programs.inverse.as_ref(), written, &name);
        let own = c::Crate {
            table: &self.source.text,
            version: env!("CARGO_PKG_VERSION"),
            path: options.dh_robot.as_deref(),
        };
        Ok(c::files(&interface, &own))
    }
}
