//! Output of the command: standard output, a file that appears only when complete, standard error.

use std::io::{Read, Write};
use std::path::Path;
use std::process::ExitCode;

/// The exit code where a claim is wrong, or two arms differ.
pub(crate) const WRONG: u8 = 1;
/// The exit code of bad usage and bad tables.
const BAD: u8 = 2;

/// What to print, and the exit code.
#[derive(Default)]
pub(crate) struct Answer {
    /// For standard output, or the file `to`.
    pub(crate) out: String,
    /// For standard error.
    pub(crate) err: String,
    /// The exit code.
    pub(crate) code: u8,
    /// The file that takes `out`.
    pub(crate) to: Option<String>,
}

impl Answer {
    /// Done.
    pub(crate) fn good(out: String) -> Answer {
        Answer { out, ..Answer::default() }
    }

    /// Errors that are drawn already.
    pub(crate) fn bad(err: String) -> Answer {
        Answer { err, code: BAD, ..Answer::default() }
    }

    /// One error in one line.
    pub(crate) fn error(message: &str) -> Answer {
        Answer::bad(format!("error: {message}\n"))
    }

    /// Bad usage.
    pub(crate) fn usage(message: &str) -> Answer {
        Answer::bad(format!("error: {message} (`dh --help` shows what there is)\n"))
    }

    /// Prints it.
    pub(crate) fn give(mut self) -> ExitCode {
        if let Some(path) = self.to.take()
            && self.code == 0
        {
            match write_whole(Path::new(&path), &self.out) {
                Ok(()) => self.out.clear(),
                Err(e) => self = Answer::error(&format!("{path}: {e}")),
            }
        }
        // A reader that has gone away (`dh notes | head`) is no error.
        let _ = std::io::stderr().write_all(self.err.as_bytes());
        let _ = std::io::stdout().write_all(self.out.as_bytes());
        ExitCode::from(self.code)
    }
}

/// The text of a file, or of standard input.
pub(crate) fn read(file: Option<&str>) -> Result<String, Answer> {
    let text = match file {
        None | Some("-") => {
            let mut text = String::new();
            std::io::stdin().read_to_string(&mut text).map(|_| text).map_err(|e| format!("standard input: {e}"))
        }
        Some(path) => std::fs::read_to_string(path).map_err(|e| format!("{path}: {e}")),
    };
    text.map_err(|message| Answer::error(&message))
}

/// Writes a file beside its place and moves it there, so that nobody sees half of it.
pub(crate) fn write_whole(path: &Path, text: &str) -> std::io::Result<()> {
    let mut name = path.file_name().ok_or_else(|| std::io::Error::other("not the name of a file"))?.to_os_string();
    name.push(format!(".{}.part", std::process::id()));
    let part = path.with_file_name(name);
    let done = std::fs::write(&part, text).and_then(|()| std::fs::rename(&part, path));
    if done.is_err() {
        let _ = std::fs::remove_file(&part);
    }
    done
}

/// Writes the files of a folder, by their paths in it. They are complete before the first one appears; a new folder appears with all of them.
///
/// # Errors
/// What is wrong: the folder is not empty and may not be written into, or a file cannot be written.
pub(crate) fn write_folder(folder: &Path, files: &[(String, String)], force: bool) -> Result<(), String> {
    let text = |e: std::io::Error| e.to_string();
    let exists = folder.exists();
    if exists && !folder.is_dir() {
        return Err("there is a file of this name".to_string());
    }
    if exists && !force && std::fs::read_dir(folder).map_err(text)?.next().is_some() {
        return Err("the folder is not empty (`--force` replaces the files of the same names)".to_string());
    }
    // On the same disk as the folder, so that moving is renaming.
    let part = format!(".dh-export.{}.part", std::process::id());
    let staged = if exists { folder.join(part) } else { folder.with_file_name(part) };
    let write = || -> std::io::Result<()> {
        std::fs::create_dir_all(&staged)?;
        for (path, text) in files {
            let place = staged.join(path);
            std::fs::create_dir_all(place.parent().unwrap_or(&staged))?;
            std::fs::write(&place, text)?;
        }
        if !exists {
            return std::fs::rename(&staged, folder);
        }
        for (path, _) in files {
            let place = folder.join(path);
            std::fs::create_dir_all(place.parent().unwrap_or(folder))?;
            std::fs::rename(staged.join(path), &place)?;
        }
        Ok(())
    };
    let done = write().map_err(text);
    let _ = std::fs::remove_dir_all(&staged);
    done
}
