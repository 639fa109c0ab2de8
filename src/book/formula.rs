//! Formulas: `$a t^2$` in a line and `$$ … $$` as a block of their own come out as MathML, which browsers show without any
//! script or font from elsewhere.
//!
//! They are found as Markdown finds them, so not in code and not in HTML. `\$` is a dollar sign, and a `$` that begins no
//! formula is a mistake: else a forgotten one would stand in the book as it is.

use std::fmt::Write;
use std::ops::Range;

use math_core::{LatexToMathML, MathCoreConfig, MathDisplay};
use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};

use crate::book::directive::untouched;
use crate::book::html::shortened;
use crate::scene::quoted;

/// A formula in a chapter, or a dollar sign that begins none.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Formula {
    /// Where it stands, in bytes, with its dollar signs.
    pub(super) range: Range<usize>,
    /// What it is.
    pub(super) is: Is,
}

/// What a dollar sign begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Is {
    /// `$…$`
    Inline,
    /// `$$…$$`
    Display,
    /// Nothing.
    Lone,
}

/// All formulas of a chapter, in order. What stands in the directives is not looked at, but a formula may hold directives.
pub(super) fn formulas(content: &str, directives: &[Range<usize>]) -> Vec<Formula> {
    if !content.contains('$') {
        return Vec::new();
    }
    let masked = masked(content, directives.iter().cloned());
    let mut found = displayed(&masked);
    // a line of a formula that begins with a - begins no list
    let masked = self::masked(&masked, found.iter().map(|formula| formula.range.clone()));
    let options = Options::ENABLE_TABLES
        | Options::ENABLE_FOOTNOTES
        | Options::ENABLE_STRIKETHROUGH
        | Options::ENABLE_TASKLISTS
        | Options::ENABLE_HEADING_ATTRIBUTES
        | Options::ENABLE_DEFINITION_LIST
        | Options::ENABLE_GFM
        | Options::ENABLE_MATH;
    let mut in_code = false;
    for (event, range) in Parser::new_ext(&masked, options).into_offset_iter() {
        match event {
            Event::Start(Tag::CodeBlock(_)) => in_code = true,
            Event::End(TagEnd::CodeBlock) => in_code = false,
            Event::InlineMath(_) => found.push(Formula {
                range,
                is: Is::Inline,
            }),
            Event::Text(_) | Event::DisplayMath(_) if !in_code => {
                let text = &masked[range.clone()];
                let lone = text.match_indices('$').map(|(at, _)| range.start + at);
                let lone = lone.filter(|&at| !masked[..at].ends_with('\\'));
                found.extend(lone.map(|at| Formula {
                    range: at..at + 1,
                    is: Is::Lone,
                }));
            }
            _ => {}
        }
    }
    found.sort_by_key(|formula| formula.range.start);
    found
}

/// The formulas `$$ … $$`, which may have several lines, but no empty one.
fn displayed(content: &str) -> Vec<Formula> {
    const MARKS: &str = "$$";
    let code = untouched(content);
    let is_code = |at: usize| code.iter().any(|piece| piece.contains(&at));
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(start) = content[at..].find(MARKS).map(|start| at + start) {
        let inner = start + MARKS.len();
        at = inner;
        if is_code(start) || content[..start].ends_with('\\') {
            continue;
        }
        let Some(end) = content[inner..].find(MARKS).map(|end| inner + end) else {
            break;
        };
        let is_empty = |line: &str| line.trim_start_matches(['>', ' ', '\t', '\r']).is_empty();
        let lines: Vec<&str> = content[inner..end].split('\n').collect();
        // the first and the last line are parts of lines
        let has_gap =
            lines.len() > 2 && lines[1..lines.len() - 1].iter().any(|line| is_empty(line));
        if has_gap || content[inner..end].trim().is_empty() {
            continue;
        }
        at = end + MARKS.len();
        found.push(Formula {
            range: start..at,
            is: Is::Display,
        });
    }
    found
}

/// The chapter with letters in the place of some pieces, byte for byte as long.
fn masked(content: &str, pieces: impl Iterator<Item = Range<usize>>) -> String {
    let mut masked = String::with_capacity(content.len());
    let mut copied = 0;
    for range in pieces {
        masked.push_str(&content[copied..range.start]);
        masked.extend(std::iter::repeat_n('x', range.len()));
        copied = range.end;
    }
    masked.push_str(&content[copied..]);
    masked
}

/// What stands between the dollar signs of a formula, without the marks of the block quotes around its lines; `before` is
/// the chapter up to it.
pub(super) fn latex(before: &str, formula: &str, is: Is) -> String {
    let marks = if is == Is::Display { 2 } else { 1 };
    // a lone dollar sign has nothing inside
    let inner = formula
        .get(marks..formula.len() - marks)
        .unwrap_or_default();
    let line = before.rfind('\n').map_or(0, |at| at + 1);
    let quotes = before[line..]
        .chars()
        .take_while(|c| c.is_whitespace() || *c == '>')
        .filter(|c| *c == '>')
        .count();
    let mut lines = inner.lines();
    let mut latex = lines.next().unwrap_or_default().to_owned();
    for mut line in lines {
        for _ in 0..quotes {
            let rest = line.trim_start();
            line = rest.strip_prefix('>').unwrap_or(rest);
        }
        latex.push(' ');
        latex.push_str(line.trim());
    }
    latex
}

/// The formula as MathML, on one line, in which Markdown finds no mark.
///
/// # Errors
/// What is no LaTeX, and where.
pub(super) fn mathml(latex: &str, is: Is) -> Result<String, String> {
    let display = match is {
        Is::Inline => MathDisplay::Inline,
        Is::Display => MathDisplay::Block,
        Is::Lone => {
            return Err(
                "this $ begins no formula\n  write \\$ for a dollar sign; a formula \
                        has no space behind its first $, and none before its last one"
                    .into(),
            );
        }
    };
    let converter =
        LatexToMathML::new(MathCoreConfig::default()).map_err(|(error, _, _)| error.to_string())?;
    let converted = converter.convert_with_local_state(latex, display);
    let converted = converted.map_err(|error| {
        let at = latex.floor_char_boundary(error.0.start.min(latex.len()));
        let rest = shortened(latex[at..].trim(), 24);
        let place = if rest.is_empty() {
            "at its end".into()
        } else {
            format!("at {}", quoted(&rest))
        };
        format!("this formula is no LaTeX, {place}: {error}\n  mend it")
    })?;
    let mathml = without_marks(&converted.mathml);
    Ok(match display {
        MathDisplay::Inline => mathml,
        // what is wider than the page scrolls, also by the keys
        MathDisplay::Block => {
            format!("<span class=\"raystep-formula\" tabindex=\"0\">{mathml}</span>")
        }
    })
}

/// HTML in whose text no character is a mark of Markdown or of mdBook, on one line.
pub(super) fn without_marks(html: &str) -> String {
    let mut safe = String::with_capacity(html.len());
    let (mut in_tag, mut in_reference) = (false, false);
    for c in html.chars() {
        match c {
            '\n' | '\r' => safe.push(' '),
            '<' => {
                in_tag = true;
                safe.push(c);
            }
            '>' => {
                in_tag = false;
                safe.push(c);
            }
            '&' => {
                in_reference = true;
                safe.push(c);
            }
            ';' if in_reference => {
                in_reference = false;
                safe.push(c);
            }
            _ if c.is_ascii_punctuation() && !in_tag && !in_reference => {
                // writing into a String does not fail
                let _ = write!(safe, "&#{};", u32::from(c));
            }
            _ => safe.push(c),
        }
    }
    safe
}

/// A number of a trace as LaTeX has it; other values are text.
///
/// # Errors
/// Text that no formula can hold.
pub(super) fn in_latex(value: &str) -> Result<String, String> {
    let plain = value.replace('−', "-");
    if plain.parse::<f64>().is_ok_and(f64::is_finite) {
        return Ok(match plain.split_once('e') {
            Some((digits, exponent)) => format!("{{{digits} \\cdot 10^{{{exponent}}}}}"),
            None => format!("{{{plain}}}"),
        });
    }
    let is_vector = |c: char| c.is_ascii_digit() || "-+.,() ".contains(c);
    if plain.chars().all(is_vector) {
        return Ok(plain);
    }
    if plain
        .chars()
        .all(|c| c.is_alphanumeric() || " .,-".contains(c))
    {
        return Ok(format!("\\text{{{plain}}}"));
    }
    Err(format!(
        "{} cannot stand in a formula\n  put the directive beside the formula",
        quoted(value)
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(content: &str) -> Vec<(Is, &str)> {
        let all = formulas(content, &[]);
        all.into_iter()
            .map(|of| (of.is, &content[of.range]))
            .collect()
    }

    #[test]
    fn formulas_stand_between_dollar_signs_and_not_in_code() {
        let content = "Let $a = 1$ and\n\n$$ b^2\n- 4ac $$\n\n`$c$` and ``x $d$``\n\n```sh\n$ e $f$\n```\n\n    $g$\n";
        assert_eq!(
            found(content),
            [(Is::Inline, "$a = 1$"), (Is::Display, "$$ b^2\n- 4ac $$")]
        );
        assert_eq!(found("| a | b |\n|---|---|\n| $x$ | *$y$* |\n").len(), 2);
        assert_eq!(found("costs \\$5, <span title=\"$x$\">*a*</span>"), []);
        assert_eq!(found("a \\$5 bill, $x$"), [(Is::Inline, "$x$")]);
        // in Markdown these lines would begin a list and underline a heading
        assert_eq!(found("$$ a\n= b\n---\n- c $$\n").len(), 1);
    }

    #[test]
    fn a_dollar_sign_that_begins_nothing_is_seen() {
        assert_eq!(found("costs $5 and $6"), [(Is::Lone, "$"), (Is::Lone, "$")]);
        assert_eq!(found("Let $a = 1, and so on"), [(Is::Lone, "$")]);
        assert_eq!(found("$$ a\n\n b $$").len(), 4);
        assert!(mathml("", Is::Lone).unwrap_err().contains("write \\$"));
    }

    #[test]
    fn a_formula_holds_directives_and_none_is_found_in_one() {
        let content = "$x = {{#raystep-value a/b c_d}}$ {{#raystep-run a '$b$'}}";
        let directives = [5..31, 33..content.len()];
        assert_eq!(
            &content[directives[0].clone()],
            "{{#raystep-value a/b c_d}}"
        );
        let all = formulas(content, &directives);
        assert_eq!(all.len(), 1);
        assert_eq!(all[0].range, 0..32);
    }

    #[test]
    fn the_lines_of_a_formula_in_a_quote_lose_their_marks() {
        let content = "> - $$a\n>   > b$$\n";
        let at = formulas(content, &[])[0].range.clone();
        assert_eq!(
            latex(&content[..at.start], &content[at], Is::Display),
            "a > b"
        );
        assert_eq!(latex("", "$$ a\n  > b $$", Is::Display), " a > b");
        assert_eq!(latex("", "$", Is::Lone), "");
    }

    #[test]
    fn what_comes_out_is_one_line_without_marks() {
        let html = mathml("a_1 * |b| < [c] \\quad \\text{x - y}", Is::Inline).unwrap();
        assert!(
            html.starts_with("<math>") && html.ends_with("</math>"),
            "{html}"
        );
        let text: String = html
            .split('<')
            .map(|part| part.split_once('>').map_or("", |(_, text)| text))
            .collect();
        assert!(!text.contains(['*', '|', '[', '_', '`', '\n']), "{text}");
        let block = mathml("\\frac{1}{2}", Is::Display).unwrap();
        assert_eq!(
            block,
            "<span class=\"raystep-formula\" tabindex=\"0\"><math display=\"block\"><mfrac><mn>1</mn><mn>2</mn></mfrac></math></span>"
        );
    }

    #[test]
    fn a_mistake_says_what_and_where() {
        let told = mathml("a + \\frca{1}{2}", Is::Inline).unwrap_err();
        assert!(told.contains("at \"\\\\frca{1}{2}\""), "{told}");
        let told = mathml("\\frac{1}", Is::Inline).unwrap_err();
        assert!(told.contains("this formula is no LaTeX"), "{told}");
    }

    #[test]
    fn a_number_in_a_formula_has_its_power_of_ten() {
        assert_eq!(in_latex("−1.5e-9").unwrap(), "{-1.5 \\cdot 10^{-9}}");
        assert_eq!(in_latex("4").unwrap(), "{4}");
        assert_eq!(in_latex("(1, −2)").unwrap(), "(1, -2)");
        assert_eq!(in_latex("two").unwrap(), "\\text{two}");
        in_latex("a\\b").unwrap_err();
    }
}
