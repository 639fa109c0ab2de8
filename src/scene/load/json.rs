//! Scenes in JSON, and the mesh files they name.

use serde::de::DeserializeOwned;

use crate::scene::file::{SceneFile, ShapeFile};
use crate::scene::load::error::{LoadError, Place, SchemaOf};
use crate::scene::load::files::Files;
use crate::scene::load::loaded::{Lines, Loaded, Source};
use crate::scene::load::locate::line_of;
use crate::scene::load::obj;
use crate::scene::load::text::text_of;

/// Reads a scene; its mesh files come from `folder`.
pub(super) fn read_json(file: &str, text: &str, folder: &dyn Files) -> Result<Loaded, LoadError> {
    let mut scene: SceneFile = parse_json(file, text, SchemaOf::Scene)?;
    let mut notes = Vec::new();
    let mut files = Vec::new();
    for (i, object) in scene.objects.iter_mut().enumerate() {
        let ShapeFile::Mesh(mesh) = &mut object.shape else {
            continue;
        };
        // a mesh with both keys is left as it is, for the check to refuse
        if let (Some(name), None) = (&mesh.file, &mesh.faces) {
            let at = format!("objects[{i}].shape.mesh.file");
            let path = folder.path_of(name).map_err(|_| LoadError::Outside {
                place: place_in(file, text, &at),
                name: name.clone(),
            })?;
            let mesh_file = path.display().to_string();
            let bytes = folder
                .read(&path)
                .map_err(|error| unreadable_mesh(place_in(file, text, &at), &mesh_file, &error))?;
            let mesh_text = text_of(&mesh_file, &bytes, "name an OBJ file")?;
            let faces = obj::read_obj(&mesh_file, mesh_text)?;
            notes.extend(faces.notes);
            mesh.faces = Some(faces.faces);
            mesh.file = None;
            files.push(path);
        }
    }
    Ok(Loaded {
        scene,
        notes,
        files,
        source: Source {
            file: file.into(),
            lines: Lines::Json(text.into()),
        },
    })
}

/// The place of a value in the text of a file.
fn place_in(file: &str, text: &str, path: &str) -> Place {
    Place {
        file: file.into(),
        line: line_of(text, path),
        path: path.into(),
    }
}

/// A mesh file that cannot be read is a mistake of the scene that names it.
fn unreadable_mesh(place: Place, mesh: &str, error: &LoadError) -> LoadError {
    let why = match error {
        LoadError::Read { source, .. } => source.to_string(),
        LoadError::Form { what, .. } => what.clone(),
        other => other.to_string(),
    };
    LoadError::Form {
        place,
        what: format!("the mesh file {mesh:?} cannot be read: {why}"),
        fix: "name an OBJ file; its path is relative to the folder of the scene".into(),
        schema: None,
    }
}

/// Reads a JSON file of a form whose schema has this name.
///
/// # Errors
/// Anything that is not of this form, with its line and path.
pub(crate) fn parse_json<T: DeserializeOwned>(
    file: &str,
    text: &str,
    schema: SchemaOf,
) -> Result<T, LoadError> {
    let mut json = serde_json::Deserializer::from_str(text);
    let value = serde_path_to_error::deserialize(&mut json).map_err(|error| {
        let path = error.path().to_string();
        form_error(file, &path, error.inner(), schema)
    })?;
    let end = json.end();
    end.map_err(|error| form_error(file, "", &error, schema))?;
    Ok(value)
}

/// What `serde_json` said, in the words of the file instead of the program's, without its place.
fn form_error(file: &str, path: &str, error: &serde_json::Error, schema: SchemaOf) -> LoadError {
    let message = error.to_string();
    let end = message.rfind(" at line ").unwrap_or(message.len());
    let what = message[..end]
        .replace(
            "invalid type: unit variant, expected struct variant",
            "a shape needs its numbers",
        )
        .replace("expected struct ", "expected the keys of ")
        .replace("EOF while parsing", "the file ends in the middle of")
        .replace("trailing characters", "unexpected text follows the end")
        .replace("expected f64", "expected a number")
        .replace("expected u32", "expected a whole number of 0 or more")
        .replace("unknown variant", "unknown name")
        .replace("unknown field", "unknown key")
        .replace("missing field", "missing key");
    let fix = if error.is_data() {
        format!(
            "compare it with the JSON Schema of a {} file",
            schema.name()
        )
    } else if what == "number out of range" {
        "give a number within ±1e50".into()
    } else {
        "correct the JSON here, or in the line before; NaN and Infinity are not JSON".into()
    };
    LoadError::Form {
        place: Place {
            file: file.into(),
            line: (0 < error.line()).then(|| error.line()),
            path: path.into(),
        },
        what,
        fix: fix.into(),
        schema: error.is_data().then_some(schema),
    }
}
