//! Options that do not belong to the strategy, and values that no structure can have.

use snapbox::{assert_data_eq, str};

use super::refuses_in;
use crate::cli::run::Folder;

/// What the command says to these options with the scene of the design.
#[track_caller]
fn refuses_options(options: &str) -> String {
    refuses_in(
        &Folder::with_scene(),
        &format!("render scene.json {options}"),
    )
}

#[test]
fn an_option_that_the_strategy_does_not_look_at_is_told_with_those_that_do() {
    // what went wrong: the picture was made as if the option had not been there
    assert_data_eq!(
        refuses_options("--strategy exhaustive --grid 4,4,4"),
        str![[r#"
error: --grid has no effect with --strategy exhaustive
  omit it, or use --strategy grid

"#]]
    );
    assert_data_eq!(
        refuses_options("--density 2"),
        str![[r#"
error: --density has no effect with hierarchy, the default of --strategy
  omit it, or use --strategy grid

"#]]
    );
    assert_data_eq!(
        refuses_options("--strategy bounds --volume sphere --slabs seven"),
        str![[r#"
error: --slabs has no effect with --strategy bounds --volume sphere
  omit it, or use --strategy hierarchy or --strategy heap or --strategy bounds --volume slabs

"#]]
    );
}

#[test]
fn every_option_of_a_structure_is_refused_where_it_would_do_nothing() {
    for (strategy, unused) in [
        ("exhaustive", "--volume box"),
        ("grid", "--volume box"),
        ("bounds", "--slabs axes"),
        ("grid", "--slabs axes"),
        ("bounds", "--build insertion"),
        ("heap", "--grid 2,2,2"),
        ("z-aligned", "--density 3"),
        ("hierarchy", "--lists boxes"),
        ("hierarchy", "--no-mailboxes"),
        ("exhaustive", "--building"),
        ("bounds", "--building"),
        ("z-aligned", "--building"),
    ] {
        let folder = Folder::with_scene();
        let option = unused.split(' ').next().unwrap();
        for verb in [
            "render scene.json -o a.png",
            "trace scene.json -o a.jsonl",
            "pixel scene.json 3,3",
        ] {
            let words = format!("{verb} --strategy {strategy} {unused}");
            let message = folder.run(&words).refused();
            let told = message.starts_with(&format!(
                "error: {option} has no effect with --strategy {strategy}"
            ));
            assert!(told, "{words}: {message}");
            assert_eq!(folder.names(), ["scene.json"], "{words}");
        }
    }
}

#[test]
fn the_cells_and_their_density_are_not_both_given() {
    assert_data_eq!(
        refuses_options("--strategy grid --grid 4,4,4 --density 3"),
        str![[r#"
error: the argument '--grid <NX,NY,NZ>' cannot be used with '--density <D>'

Usage: raystep render --output <F.png> --strategy <NAME> --grid <NX,NY,NZ> <SCENE>

For more information, try '--help'.

"#]]
    );
}

#[test]
fn a_density_that_is_none_has_one_message_whatever_it_is() {
    let message = refuses_options("--strategy grid --density 0");
    assert_data_eq!(
        &message,
        str![[r#"
error: invalid value '0' for '--density <D>': give a number of cells for each object above 0, such as 3

For more information, try '--help'.

"#]]
    );
    for density in ["-1", "inf", "-inf", "nan", "1e999", "many", "-1,2"] {
        for between in [" ", "="] {
            let options = format!("--strategy grid --density{between}{density}");
            assert_eq!(
                refuses_options(&options),
                message.replace("'0'", &format!("'{density}'")),
                "{options}"
            );
        }
    }
}

#[test]
fn a_strategy_that_does_not_exist_is_told_with_those_that_do() {
    assert_data_eq!(
        refuses_options("--strategy octree"),
        str![[r#"
error: invalid value 'octree' for '--strategy <NAME>'
  [possible values: exhaustive, bounds, hierarchy, heap, grid, z-aligned]

For more information, try '--help'.

"#]]
    );
    assert_data_eq!(
        refuses_options("--strategy hierachy"),
        str![[r#"
error: invalid value 'hierachy' for '--strategy <NAME>'
  [possible values: exhaustive, bounds, hierarchy, heap, grid, z-aligned]

  tip: a similar value exists: 'hierarchy'

For more information, try '--help'.

"#]]
    );
}

#[test]
fn a_log_is_not_traced_again_with_another_strategy() {
    let folder = Folder::with_scene();
    folder
        .run("trace scene.json --region 3,3 -o a.jsonl")
        .well();
    assert_data_eq!(
        folder
            .run("pixel a.jsonl 3,3 --strategy grid --density 2")
            .refused(),
        str![[r#"
error: a.jsonl: this is a log, and --strategy and --density ask for new rays, which need the scene
  give the scene; 'raystep convert' extracts it from the log

"#]]
    );
    assert_data_eq!(
        folder
            .run("trace a.jsonl -o b.jsonl --strategy heap")
            .refused(),
        str![[r#"
error: a.jsonl: this is a log, and --strategy asks for new rays, which need the scene
  give the scene; 'raystep convert' extracts it from the log

"#]]
    );
}

#[test]
fn a_grid_of_two_numbers_is_told() {
    assert_data_eq!(
        refuses_options("--strategy grid --grid 1,2"),
        str![[r#"
error: invalid value '1,2' for '--grid <NX,NY,NZ>': give the cells along x, y and z, as in 46,46,3

For more information, try '--help'.

"#]]
    );
}
