//! A comparison of strategies as text: a table that a terminal of 80 columns holds, or the one with all columns.

use crate::explain::compare::{in_one_line, per_ray};
use crate::explain::table::{aligned, wrapped};
use crate::explain::{Compared, Comparison, Cost, grouped, in_advance, in_advance_text};

/// The columns of the narrow table after the name. The names take up to 31 letters, and the numbers have room for 12
/// digits: 10¹² tests take hours.
const NARROW: [&str; 4] = ["object tests", "search", "per ray", "share %"];

/// What two of the columns are.
const COLUMNS_MEAN: &str =
    "per ray: object tests of a ray; share %: object tests, as a share of exhaustive";

impl Comparison<'_> {
    /// The table in 80 columns, the cheapest strategy first, and what was computed in advance.
    ///
    /// Object tests of all kinds are one column, and so is the search for these objects: bound tests, nodes entered
    /// and cells visited.
    pub fn text(&self) -> String {
        let mut table = vec![vec!["strategy".to_owned()]];
        table[0].extend(NARROW.map(String::from));
        let mut not_built = String::new();
        for compared in self.by_cost() {
            let mut row = vec![compared.name()];
            match &compared.cost {
                Ok(cost) => row.extend(self.narrow_cells(cost)),
                Err(why) => {
                    row.push("not built".into());
                    let why = format!("{}: not built: {}", compared.name(), in_one_line(why));
                    not_built += &wrapped(&why, "", "  ");
                }
            }
            table.push(row);
        }
        let rays = self.compared.iter().find_map(|one| one.cost.as_ref().ok());
        let rays = rays.map_or(0, |cost| cost.counts.traced());
        let sorted = format!(
            "{} {}; sorted by object tests + search (bound tests, nodes, cells)",
            grouped(rays),
            if rays == 1 { "ray" } else { "rays" }
        );
        format!(
            "{}{}{}\n{}{not_built}{}",
            wrapped(&self.title(), "", "  "),
            wrapped(&sorted, "", "  "),
            wrapped(COLUMNS_MEAN, "", "  "),
            aligned(&table),
            self.below()
        )
    }

    /// The table with a column for each kind of test, rays, times and memory, the cheapest strategy first, and what
    /// was computed in advance.
    pub fn wide_text(&self) -> String {
        let table = self.table(&self.columns(), self.by_cost().into_iter());
        format!("{}\n\n{}{}", self.title(), aligned(&table), self.below())
    }

    /// The strategies in the order of their cost; those that could not be built come last.
    fn by_cost(&self) -> Vec<&Compared> {
        let mut sorted: Vec<&Compared> = self.compared.iter().collect();
        // of equal costs the order stays
        sorted.sort_by_key(|one| one.cost.as_ref().map_or(u64::MAX, Cost::total));
        sorted
    }

    /// One cell for each of [`NARROW`].
    fn narrow_cells(&self, cost: &Cost) -> [String; NARROW.len()] {
        [
            cost.counts.objects_tested().to_string(),
            cost.searched().to_string(),
            format!("{:.2}", per_ray(&cost.counts)),
            self.share(cost)
                .map(|share| format!("{share:.2}"))
                .unwrap_or_default(),
        ]
    }

    /// What stands below either table: that a grid is crowded, and what was computed in advance.
    fn below(&self) -> String {
        let mut text = String::new();
        let mut costs = self
            .compared
            .iter()
            .filter_map(|one| one.cost.as_ref().ok());
        if let Some(crowded) = costs.find_map(|cost| cost.crowded) {
            text.push('\n');
            text += &wrapped(&crowded.to_string(), "", "  ");
        }
        let advance = self.in_advance_lines();
        if !advance.is_empty() {
            text += "\ncomputed in advance\n";
            text += &advance;
        }
        text
    }

    /// Each strategy for which something was computed in advance and used, and under it what.
    fn in_advance_lines(&self) -> String {
        let mut text = String::new();
        for compared in self.by_cost() {
            let Ok(cost) = &compared.cost else { continue };
            let list = in_advance_text(&in_advance(self.scene, &compared.settings, &cost.counts));
            if list.is_empty() {
                continue;
            }
            text += &wrapped(&compared.name(), "  ", "  ");
            let lines = list.lines().map(|line| wrapped(line, "    ", "      "));
            text.extend(lines);
        }
        text
    }
}
