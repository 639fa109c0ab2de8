//! `raystep book`: a book built by the library of mdBook, where the program was built with the feature `course`.

use std::path::{Path, PathBuf};

use crate::cli::Error;
use crate::cli::args::{BookArgs, BookVerb};

/// Does what is asked for.
pub(crate) fn run(args: &BookArgs) -> Result<(), Error> {
    let BookVerb::Build { dir, output } = &args.verb;
    let root = root(dir.as_deref())?;
    build(&root, output.as_deref())
}

/// The folder with `book.toml`.
fn root(dir: Option<&Path>) -> Result<PathBuf, Error> {
    let usual = [Path::new("book"), Path::new(".")];
    let tried = dir.as_slice();
    let tried = if tried.is_empty() { &usual[..] } else { tried };
    let found = tried.iter().find(|dir| dir.join("book.toml").is_file());
    found.map(|dir| dir.to_path_buf()).ok_or_else(|| {
        let names: Vec<String> = tried.iter().map(|dir| dir.display().to_string()).collect();
        Error::Course {
            what: format!("there is no book.toml in {}", names.join(" or ")),
            fix: "name the folder of the book, or begin one with 'raystep init DIR'".into(),
        }
    })
}

#[cfg(not(feature = "course"))]
fn build(root: &Path, _: Option<&Path>) -> Result<(), Error> {
    Err(Error::Course {
        what: "this program was built without the feature course".into(),
        fix: format!(
            "build it with: cargo install --path . --features course, or install mdBook and run: mdbook build {}",
            root.display()
        ),
    })
}

#[cfg(feature = "course")]
use with_mdbook::build;

#[cfg(feature = "course")]
mod with_mdbook {
    use std::env;
    use std::fmt::{Debug, Write};
    use std::fs;
    use std::path::Path;

    use mdbook_driver::MDBook;
    use mdbook_driver::config::Config;
    use raystep::book::PrintPage;
    use tracing::field::{Field, Visit};
    use tracing::span::{Attributes, Id, Record};
    use tracing::{Event, Level, Metadata, Subscriber};

    use crate::cli::Error;
    use crate::cli::notes::note;
    use crate::cli::output_folder::{self, OutputFolder};

    /// Builds the pages of a book into its build folder, or into another one.
    pub(super) fn build(root: &Path, output: Option<&Path>) -> Result<(), Error> {
        let failed = |error: &dyn std::fmt::Display| Error::Course {
            what: format!("{}: {error}", root.join("book.toml").display()),
            fix: "mend it; https://rust-lang.github.io/mdBook describes its keys".into(),
        };
        // the preprocessor runs in this folder
        let root = &std::path::absolute(root).map_err(|error| failed(&error))?;
        let mut config = Config::from_disk(root.join("book.toml"))
            .map_err(|error| failed(&format!("{error:#}")))?;
        let target = match output {
            Some(output) => output.to_path_buf(),
            None => root.join(&config.build.build_dir),
        };
        let folder = OutputFolder::create(&target, is_built)?;
        config.build.build_dir = folder.path();
        // a chapter that is missing is a mistake, and the source is not written to
        config.build.create_missing = false;
        let program = env::current_exe().map_err(|error| failed(&error))?;
        let command = format!("{} mdbook", for_shell(&program.display().to_string()));
        let set = config.set("preprocessor.raystep.command", command);
        set.map_err(|error| failed(&format!("{error:#}")))?;
        // nobody else listens in this program
        let _ = tracing::subscriber::set_global_default(Warnings);
        let built = MDBook::load_with_config(root, config).and_then(|book| book.build());
        built.map_err(|error| Error::Course {
            what: format!("{error:#}"),
            fix: "mend this, and build the book again; nothing was written".into(),
        })?;
        for_paper(&folder.path())?;
        folder.finish()?;
        note(&format!(
            "the book is in {}: open {}",
            target.display(),
            target.join("index.html").display()
        ));
        Ok(())
    }

    /// The page with all chapters, where the book has one, is made lighter: its drawings become files.
    fn for_paper(folder: &Path) -> Result<(), Error> {
        let page = folder.join("print.html");
        if !page.is_file() {
            return Ok(());
        }
        let failed = |file: &Path| {
            let file = file.to_path_buf();
            move |error| output_folder::failed(&file, error)
        };
        let light = PrintPage::of(&fs::read_to_string(&page).map_err(failed(&page))?);
        for (path, drawing) in &light.drawings {
            let file = folder.join(path);
            if let Some(parent) = file.parent() {
                fs::create_dir_all(parent).map_err(failed(parent))?;
            }
            fs::write(&file, drawing).map_err(failed(&file))?;
        }
        fs::write(&page, light.html).map_err(failed(&page))
    }

    /// Is this an older build of a book, and nothing else? mdBook writes both files into each.
    fn is_built(folder: &Path) -> bool {
        let has = |file: &str| folder.join(file).is_file();
        has("index.html") && has(".nojekyll") && !folder.join(".git").exists()
    }

    /// A path as mdBook splits a command into words.
    fn for_shell(path: &str) -> String {
        format!("'{}'", path.replace('\'', "'\\''"))
    }

    /// What mdBook warns of, as notes.
    struct Warnings;

    impl Subscriber for Warnings {
        fn enabled(&self, metadata: &Metadata<'_>) -> bool {
            *metadata.level() <= Level::WARN
        }

        fn event(&self, event: &Event<'_>) {
            let mut message = Message(String::new());
            event.record(&mut message);
            note(&message.0);
        }

        fn new_span(&self, _: &Attributes<'_>) -> Id {
            Id::from_u64(1)
        }

        fn record(&self, _: &Id, _: &Record<'_>) {}
        fn record_follows_from(&self, _: &Id, _: &Id) {}
        fn enter(&self, _: &Id) {}
        fn exit(&self, _: &Id) {}
    }

    struct Message(String);

    impl Visit for Message {
        fn record_debug(&mut self, field: &Field, value: &dyn Debug) {
            // writing into a String does not fail
            let _ = match field.name() {
                "message" => write!(self.0, "{value:?}"),
                name => write!(self.0, " {name}={value:?}"),
            };
        }
    }
}
