//! Tables of numbers, as text and as CSV.

/// Names to the left, numbers to the right, each column as wide as its widest cell. A row of two cells in a
/// wider table is a name with a remark.
pub(super) fn aligned(table: &[Vec<String>]) -> String {
    let columns = table.first().map_or(0, Vec::len);
    let width = |column: usize| {
        let rows = table
            .iter()
            .filter(|row| column == 0 || row.len() == columns);
        let cells = rows.filter_map(|row| row.get(column));
        cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..columns).map(width).collect();
    let mut text = String::new();
    for row in table {
        let mut line = String::new();
        for (column, (cell, width)) in row.iter().zip(&widths).enumerate() {
            // a remark is longer than its column, and moves nothing
            let cell = match column {
                0 => format!("{cell:<width$}"),
                _ if row.len() < columns => cell.clone(),
                _ => format!("{cell:>width$}"),
            };
            line += &cell;
            line += "  ";
        }
        text += line.trim_end();
        text.push('\n');
    }
    text
}

/// Columns of a terminal.
const WIDTH: usize = 80;

/// The text in lines of at most 80 columns, each with a line break at its end. The first begins with one indent, the
/// others with the other. A word that is longer stands alone on its line.
pub(super) fn wrapped(text: &str, first: &str, others: &str) -> String {
    let mut lines = String::new();
    let mut line = String::from(first);
    let mut is_empty = true;
    for word in text.split(' ') {
        if !is_empty && WIDTH < line.chars().count() + 1 + word.chars().count() {
            lines += &line;
            lines.push('\n');
            line = others.into();
            is_empty = true;
        }
        if !is_empty {
            line.push(' ');
        }
        line += word;
        is_empty = false;
    }
    lines + &line + "\n"
}

/// A row of CSV: cells with commas, quotes or line breaks are quoted (RFC 4180, 2.6 and 2.7).
pub(super) fn csv_row<'a>(cells: impl IntoIterator<Item = &'a str>) -> String {
    let quoted = cells.into_iter().map(|cell| {
        if cell.contains([',', '"', '\n', '\r']) {
            format!("\"{}\"", cell.replace('"', "\"\""))
        } else {
            cell.into()
        }
    });
    let row: Vec<String> = quoted.collect();
    format!("{}\n", row.join(","))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_with_a_comma_or_a_quote_is_quoted() {
        assert_eq!(
            csv_row(["x", "a, \"b\"", "7", ""]),
            "x,\"a, \"\"b\"\"\",7,\n"
        );
    }

    #[test]
    fn a_long_text_is_broken_between_words_at_eighty_columns() {
        // an indent of 4, 73 letters, a blank and 2 letters: the line is full
        let long = "a".repeat(73);
        assert_eq!(
            wrapped(&format!("{long} bé c"), "    ", "  "),
            format!("    {long} bé\n  c\n")
        );
        assert_eq!(
            wrapped(&format!("{long} bcd e"), "    ", "  "),
            format!("    {long}\n  bcd e\n")
        );
        let longer = "a".repeat(99);
        assert_eq!(
            wrapped(&format!("b {longer} c"), "", "  "),
            format!("b\n  {longer}\n  c\n")
        );
        assert_eq!(wrapped("", "", "  "), "\n");
    }

    #[test]
    fn numbers_end_in_one_column_and_a_remark_widens_none() {
        let rows = [
            vec!["name", "number", "n"],
            vec!["a", "104857600", "1"],
            vec!["long name", "not built: a long reason"],
        ];
        let table = rows.map(|row| row.into_iter().map(String::from).collect());
        assert_eq!(
            aligned(&table),
            "name          number  n\n\
             a          104857600  1\n\
             long name  not built: a long reason\n"
        );
    }
}
