//! A grid most of whose objects lie in one cell is reported, with what helps.

use std::fmt::Write as _;

use super::{LESSON, entry, json_of, text_of};
use crate::cli::run::Folder;

/// Forty spheres around the middle of a floor that is 10 000 on each side.
fn small_on_large() -> String {
    let mut text = String::from(
        "v\nfrom 0 3 9\nat 0 0 0\nup 0 1 0\nangle 40\nhither 1\nresolution 8 6\nl 3 4 9\n\
         f 1 1 1 1 0 0 0 0\np 4 -5000 0 -5000 -5000 0 5000 5000 0 5000 5000 0 -5000\n",
    );
    for i in 0..40 {
        let (x, z) = (0.4 * f64::from(i % 8) - 1.4, 0.4 * f64::from(i / 8) - 0.8);
        writeln!(text, "s {x} 0.5 {z} 0.15").unwrap();
    }
    text
}

/// 41 objects and 3 cells for each are 123. The box is too flat for a second cell along y: √123 = 11.1 along x and z.
/// The middle of the floor is the middle of cell [5, 0, 5], and that is 909 wide.
const TOLD: &str = "the grid is crowded: cell [5, 0, 5] lists 41 of the 41 objects, and each ray through it is tested \
                    against all of these; the hierarchy adapts to such a scene, a grid needs many more cells";

#[test]
fn a_grid_with_most_objects_in_one_cell_is_told_with_what_helps() {
    let folder = Folder::empty().with("s.nff", small_on_large());
    let text = text_of(&folder, "compare s.nff");
    let in_one_line = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert_eq!(in_one_line.matches(TOLD).count(), 1, "{text}");
    assert!(
        text.lines().all(|line| line.chars().count() <= 80),
        "{text}"
    );

    let json = json_of(&folder, "compare s.nff");
    let expected = serde_json::json!({ "cell": [5, 0, 5], "listed": 41, "objects": 41 });
    for grid in ["grid, mailboxes", "grid, no mailboxes"] {
        assert_eq!(entry(&json, grid)["crowded_cell"], expected);
    }
    assert!(entry(&json, "hierarchy, bottom-up")["crowded_cell"].is_null());

    for verb in [
        "render s.nff -o a.png",
        "trace s.nff -o a.jsonl",
        "pixel s.nff 3,3",
    ] {
        let stats = |strategy: &str| {
            folder
                .run(&format!("{verb} --strategy {strategy} --stats"))
                .noted()
        };
        assert!(stats("grid").contains(&format!("\n{TOLD}\n")), "{verb}");
        assert!(!stats("hierarchy").contains("crowded"), "{verb}");
    }
    // cut in the middle of the spheres: four of the eight columns and three of the five rows lie in one of four cells,
    // for the middle row lies in two, and 12 spheres and the floor are 13 of 41
    let stats = folder.run("render s.nff -o a.png --stats --strategy grid --grid 2,1,2");
    assert!(!stats.noted().contains("crowded"));
}

#[test]
fn a_grid_over_objects_everywhere_is_not_crowded() {
    let folder = Folder::empty().with("scene.json", LESSON);
    let words = "compare scene.json --pixels 16,16";
    assert!(entry(&json_of(&folder, words), "grid, mailboxes")["crowded_cell"].is_null());
    assert!(!text_of(&folder, words).contains("crowded"));
}
