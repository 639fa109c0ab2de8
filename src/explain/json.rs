//! The working of a pixel as one JSON document: the tree of its rays, and those of the paths of light behind it.

use serde_json::{Map, Value, json};

use crate::scene::Scene;
use crate::trace::{Item, LogNames, RayTree, Record, Settings, write_event};

/// The working of a pixel as a tree: `pixel`, `settings`, `events` of the pixel itself, and `rays`, each
/// with its `events` as the log has them and the `rays` that it spawned.
///
/// Where light was followed, `paths` are those that led to the pixel: each with its number as `path`, its `events`
/// and its `rays`, which are numbered from 0 again.
pub fn pixel_json(scene: &Scene, settings: &Settings, records: &[Record]) -> Value {
    let names = LogNames::new(scene);
    let is_of_path = |record: &Record| record.path.is_some();
    let (of_paths, own): (Vec<Record>, Vec<Record>) = records.iter().partition(|r| is_of_path(r));

    let mut document = tree(&own, &names);
    document.insert("scene".into(), scene.name.clone().into());
    document.insert("settings".into(), json!(settings));
    if let Some(pixel) = own.iter().find_map(|record| record.pixel) {
        document.insert("pixel".into(), json!(pixel));
    }
    if settings.transport.follows_light() {
        let paths = of_paths.chunk_by(|a, b| a.path == b.path).map(|path| {
            let mut object = tree(path, &names);
            object.insert(
                "path".into(),
                json!(path.first().and_then(|first| first.path)),
            );
            Value::Object(object)
        });
        document.insert("paths".into(), paths.collect());
    }
    Value::Object(document)
}

/// The events and rays of a pixel or a path.
fn tree(records: &[Record], names: &LogNames) -> Map<String, Value> {
    let tree = RayTree::new(records);
    node(&tree.items, &tree, records, names)
}

fn node(
    items: &[Item],
    tree: &RayTree,
    records: &[Record],
    names: &LogNames,
) -> Map<String, Value> {
    let mut events = Vec::new();
    let mut rays = Vec::new();
    for item in items {
        match *item {
            Item::Event(at) => events.push(event(&records[at], names)),
            Item::Ray(place) => {
                let ray = &tree.rays[place];
                let mut object = node(&ray.items, tree, records, names);
                object.insert("id".into(), ray.id.into());
                for (key, at) in ["start", "end"].into_iter().zip(ray.ends_at) {
                    if let Some(at) = at {
                        object.insert(key.into(), event(&records[at], names));
                    }
                }
                rays.push(Value::Object(object));
            }
        }
    }
    let mut object = Map::new();
    object.insert("events".into(), events.into());
    object.insert("rays".into(), rays.into());
    object
}

/// An event as the log has it.
fn event(record: &Record, names: &LogNames) -> Value {
    let mut line = Vec::new();
    write_event(record, names, &mut line);
    serde_json::from_slice(&line).unwrap_or(Value::Null)
}
