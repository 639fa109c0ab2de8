//! Scenes and options through which no light can be followed.

use snapbox::{assert_data_eq, str};

use super::refuses_in;
use crate::cli::run::Folder;

/// A lamp over a floor, and a ball beside it.
pub(crate) const LAMP: &str = r#"{
  "camera": { "look_at": { "cop": [0, 2, 6], "target": [0, 0, 0], "up": [0, 1, 0], "fov_degrees": 40 },
              "pixels": [8, 6] },
  "lights": [ { "name": "lamp", "position": [0, 3, 0], "power": 100 } ],
  "materials": { "grey": { "colour": [0.5, 0.5, 0.5], "diffuse": 0.8 } },
  "objects": [
    { "name": "floor", "material": "grey",
      "shape": { "polygon": { "vertices": [[-4, 0, -4], [-4, 0, 4], [4, 0, 4], [4, 0, -4]] } } },
    { "name": "ball", "material": "grey", "sides": "front",
      "shape": { "sphere": { "center": [2, 1, 0], "radius": 1 } } }
  ]
}"#;

/// The three transports that follow light.
const FOLLOW: [&str; 3] = ["forward", "hybrid-stored", "hybrid-connected"];

/// What the command says to the scene with one thing changed; the same with each transport that follows light, and
/// from every verb.
#[track_caller]
fn refuses_with(from: &str, to: &str) -> String {
    assert!(LAMP.contains(from), "the scene has no {from}");
    let folder = Folder::empty().with("scene.json", LAMP.replacen(from, to, 1));
    let first = refuses_in(&folder, "render scene.json --transport forward");
    for transport in FOLLOW {
        for verb in ["render scene.json", "trace scene.json"] {
            let words = format!("{verb} --transport {transport}");
            assert_eq!(refuses_in(&folder, &words), first, "{words}");
        }
        let words = format!("pixel scene.json 1,1 --transport {transport}");
        assert_eq!(folder.run(&words).refused(), first, "{words}");
    }
    let compared = folder.run("compare scene.json --transports").refused();
    assert_eq!(compared, first);
    // backward, the same scene is a picture
    folder
        .run("render scene.json -o x.png --transport backward")
        .well();
    first
}

/// What it says to options, with a scene that is in order.
#[track_caller]
fn refuses_options(options: &str) -> String {
    let folder = Folder::empty().with("scene.json", LAMP);
    refuses_in(&folder, &format!("render scene.json {options}"))
}

#[test]
fn without_lights_there_is_nothing_to_follow() {
    assert_data_eq!(
        refuses_with(
            r#"{ "name": "lamp", "position": [0, 3, 0], "power": 100 }"#,
            ""
        ),
        str![[r#"
error: scene.json: the scene has no lights, and this kind of ray tracing starts at the lights
  give the scene a light, such as { "position": [0, 4, 0], "power": 100 }

"#]]
    );
}

#[test]
fn a_light_with_a_colour_does_not_say_how_much_it_sends_out() {
    assert_data_eq!(
        refuses_with(r#""power": 100"#, r#""colour": [1, 1, 1]"#),
        str![[r#"
error: scene.json: lights[0], "lamp", has a colour but no power, so the light that it emits is not known
  replace lights[0].colour by "power", in watts, or choose --transport hybrid-light

"#]]
    );
}

#[test]
fn a_power_of_nothing_or_less_is_refused_with_its_line() {
    for power in ["0", "-5"] {
        let folder = Folder::empty().with("scene.json", LAMP.replacen("100", power, 1));
        let message = refuses_in(&folder, "render scene.json --transport forward");
        assert!(
            message.contains("lights[0].power") && message.contains("line 4"),
            "{message}"
        );
    }
}

#[test]
fn a_surface_that_sends_on_more_than_arrives_is_told_with_its_material() {
    // 0.5 · 1.2 + 0.5 = 1.1
    assert_data_eq!(
        refuses_with(r#""diffuse": 0.8"#, r#""diffuse": 1.2, "reflection": 0.5"#),
        str![[r#"
error: scene.json: materials.grey reflects and transmits 1.1 times the incoming light: energy would grow at every bounce
  lower diffuse, reflection or transmission of materials.grey, so that for each channel colour·diffuse + reflection + transmission is at most 1

"#]]
    );
    // 0.5 · 2 is 1, which is allowed
    let folder = Folder::empty().with("scene.json", LAMP.replacen("0.8", "2", 1));
    folder
        .run("render scene.json --transport hybrid-stored --paths 100 -o x.png")
        .well();
}

#[test]
fn a_light_in_opaque_matter_that_nothing_shows_from_inside_is_a_mistake() {
    assert_data_eq!(
        refuses_with("[0, 3, 0]", "[2, 1.5, 0]"),
        str![[r#"
error: scene.json: the light "lamp" is inside "ball", which is opaque and whose inside is not visible
  move the light, or give "ball" "sides": "back" to show it from inside

"#]]
    );
}

#[test]
fn a_light_that_stays_inside_away_from_the_eye_is_worth_a_note() {
    let scene =
        LAMP.replacen("[0, 3, 0]", "[2, 1.5, 0]", 1)
            .replacen(r#""sides": "front","#, "", 1);
    let folder = Folder::empty().with("scene.json", scene);
    let words = "render scene.json --transport forward --paths 100 -o x.png";
    let noted = folder.run(words).noted();
    let expected = "note: the light \"lamp\" is inside \"ball\", which is opaque: none of its light reaches \
                    the eye\n";
    assert_eq!(noted, expected);
}

#[test]
fn what_the_paths_of_light_do_not_look_at_is_noted() {
    let scene = LAMP.replacen("\"lights\"", "\"ambient\": [0.1, 0.1, 0.1], \"lights\"", 1);
    let folder = Folder::empty().with("scene.json", scene);
    let words = "render scene.json --transport hybrid-connected --samples 1 -o x.png";
    let expected = "note: the ambient light and the background are ignored: only the light of the lights is \
                    traced\n";
    assert_eq!(folder.run(words).noted(), expected);
}

#[test]
fn a_pinhole_is_explained_not_hidden() {
    let folder = Folder::empty().with("scene.json", LAMP);
    let words = "render scene.json --transport forward --aperture 0 --paths 1000 -o x.png";
    let expected = "note: the eye is a pinhole, with aperture 0: no photon passes through a point, so the \
                    picture is black; an aperture gives the eye a radius\n";
    assert_eq!(folder.run(words).noted(), expected);
}

#[test]
fn no_paths_are_too_few() {
    assert_data_eq!(
        refuses_options("--transport forward --paths 0"),
        str![[r#"
error: scene.json: --paths 0: no light would be followed
  give --paths a number of at least 1

"#]]
    );
    assert_data_eq!(
        refuses_options("--transport hybrid-connected --samples 0"),
        str![[r#"
error: scene.json: --samples 0: no light would be followed
  give --samples a number of at least 1

"#]]
    );
}

#[test]
fn too_many_paths_are_refused_with_what_they_would_take() {
    // the time is measured: it is another one each time
    let refuses = |options: &str| {
        let folder = Folder::empty().with("scene.json", LAMP);
        let message = folder
            .run(&format!("render scene.json -o out.png {options}"))
            .refused();
        assert_eq!(folder.names(), ["scene.json"]);
        message
    };
    assert_data_eq!(
        refuses("--transport forward --paths 1000000000000"),
        str![[r#"
error: scene.json: 1000000000000 paths of light are too many: their numbers have 32 bits
  give --paths a number of at most 4294967295

"#]]
    );
    assert_data_eq!(
        refuses("--transport hybrid-stored --paths 1000000000000"),
        str![[r#"
error: scene.json: the photons of 1000000000000 paths of light would take about [..] TB of memory
  give --paths a number of at most [..]

"#]]
    );
    // 8 · 6 pixels · 4 000 000 000
    assert_data_eq!(
        refuses("--transport hybrid-connected --samples 4000000000"),
        str![[r#"
error: scene.json: 192000000000 paths of light are too many: their numbers have 32 bits
  give --samples a number of at most 89478485

"#]]
    );
}

#[test]
fn light_that_nothing_absorbs_and_that_does_not_get_out_is_refused() {
    // what went wrong: each path met 10 000 surfaces, and each line between them was drawn
    let room = r#"{ "name": "room", "material": "white",
        "shape": { "box": { "min": [-9, -9, -9], "max": [9, 9, 9] } } }, { "name": "floor""#;
    let scene = LAMP
        .replacen(r#"{ "name": "floor""#, room, 1)
        .replacen(
            r#""materials": {"#,
            r#""materials": { "white": { "colour": [1, 1, 1], "diffuse": 1 },"#,
            1,
        )
        .replacen("0.5, 0.5, 0.5", "1, 1, 1", 1)
        .replacen("0.8", "1", 1);
    let folder = Folder::empty().with("scene.json", scene);
    for transport in FOLLOW {
        let message = refuses_in(
            &folder,
            &format!("render scene.json --transport {transport}"),
        );
        assert_data_eq!(
            message,
            str![[r#"
error: scene.json: a path of light hit 10000 surfaces and did not end: the surfaces absorb almost nothing, and the path cannot leave
  lower the albedo of a material, or end the paths with --bounces, such as --bounces 20

"#]]
        );
    }
    let words = "render scene.json --transport forward --paths 100 --bounces 5 -o x.png";
    folder.run(words).well();
}

#[test]
fn maps_that_do_not_fit_into_memory_are_refused_with_what_they_would_take() {
    // what went wrong: the memory ran out and the program was killed. 15 boxes have 180 sides; with the floor's 2,
    // 182 · 4096² · 32 bytes are 97.7 GB, and 2 GiB hold √(2³¹/(182·32)) = 607.2 cells along a side
    let crate_of = |i: usize| {
        format!(
            r#"{{ "name": "box {i}", "material": "grey",
            "shape": {{ "box": {{ "min": [{i}, 9, 0], "max": [{i}.5, 10, 1] }} }} }}, "#
        )
    };
    let boxes: String = (0..15).map(crate_of).collect();
    let scene = LAMP.replacen(
        r#"{ "name": "floor""#,
        &format!(r#"{boxes}{{ "name": "floor""#),
        1,
    );
    let folder = Folder::empty().with("scene.json", scene);
    assert_data_eq!(
        refuses_in(
            &folder,
            "render scene.json --transport hybrid-stored --map 4096"
        ),
        str![[r#"
error: scene.json: maps with 4096 cells along the longer side, on 182 sides of flat faces, would take up to 98 GB of memory
  give --map a number of at most 607

"#]]
    );
}

#[test]
fn numbers_out_of_their_range_are_told_with_the_range() {
    for (options, must) in [
        ("--transport hybrid-stored --nearest 1", "at least 2"),
        ("--transport hybrid-stored --map 0", "from 1 to 4096"),
        ("--transport hybrid-stored --map 4097", "from 1 to 4096"),
        ("--transport forward --bounces 0", "at least 1"),
        ("--transport forward --aperture -1", "0 or more"),
        ("--transport forward --aperture NaN", "0 or more"),
        ("--transport forward --aperture 1e51", "at most 1e50"),
    ] {
        let message = refuses_options(options);
        assert!(message.contains(must), "{options}: {message}");
    }
}

#[test]
fn an_option_that_the_transport_does_not_look_at_is_told_with_those_that_do() {
    assert_data_eq!(
        refuses_options("--transport forward --nearest 9"),
        str![[r#"
error: --nearest has no effect with --transport forward
  omit it, or use --transport hybrid-stored

"#]]
    );
    // what went wrong: "has no effect with --transport hybrid-light", and nobody had written that
    assert_data_eq!(
        refuses_options("--nearest 9"),
        str![[r#"
error: --nearest has no effect with hybrid-light, the default of --transport
  omit it, or use --transport hybrid-stored

"#]]
    );
    for (transport, unused) in [
        ("backward", "--seed 1"),
        ("hybrid-light", "--paths 10"),
        ("hybrid-connected", "--paths 10"),
        ("forward", "--samples 2"),
        ("hybrid-light", "--bounces 2"),
        ("hybrid-stored", "--aperture 0.1"),
        ("hybrid-connected", "--map 8"),
        ("forward", "--through corners"),
        ("hybrid-connected", "--max-depth 3"),
    ] {
        let message = refuses_options(&format!("--transport {transport} {unused}"));
        let option = unused.split(' ').next().unwrap();
        let expected = format!("error: {option} has no effect with --transport {transport}\n");
        assert!(message.starts_with(&expected), "{message}");
    }
}

#[test]
fn where_no_ray_belongs_to_one_pixel_there_is_no_heat_map() {
    for transport in ["forward", "hybrid-connected"] {
        let message = refuses_options(&format!("--transport {transport} --heatmap tests"));
        assert!(
            message.starts_with("error: --heatmap has no effect"),
            "{message}"
        );
    }
}
