//! `raystep schema`: the JSON Schemas of the files that are read and written.

use raystep::lesson::lesson_schema;
use raystep::trace::{scene_schema, trace_schema};

use crate::cli::Error;
use crate::cli::args::{SchemaArgs, SchemaOf};
use crate::cli::output::Output;

/// Prints a schema.
pub(crate) fn run(args: &SchemaArgs) -> Result<(), Error> {
    let schema = match args.of {
        SchemaOf::Scene => scene_schema(),
        SchemaOf::Lesson => lesson_schema(),
        SchemaOf::Trace => trace_schema(),
    };
    Output::standard().write_whole(format!("{schema:#}\n").as_bytes())
}
