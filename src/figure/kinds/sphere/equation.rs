//! The parabola of equation (iii), and its zeros.

use crate::figure::kinds::sphere::argument::Argument;
use crate::figure::kinds::sphere::solved::Solved;
use crate::figure::parts::parabola::{self, Extent};
use crate::figure::sheet::canvas::{coordinates, quantity};
use crate::figure::sheet::frame::Frame;
use crate::figure::sheet::text::formula;
use crate::figure::sheet::{Sheet, Width};
use crate::figure::spec::Layer;
use crate::figure::subject::Figure;
use crate::geometry::{QuadraticTest, Roots};

/// f(t), what its discriminant says, and its graph.
pub(super) fn draw(
    figure: &Figure,
    sheet: &mut Sheet,
    frame: Frame,
    solved: &Solved,
    argument: &Argument,
) {
    let numbers = figure.shows(Layer::Numbers);
    let mut rest = frame;
    if numbers && sheet.width == Width::Book {
        let center = coordinates(solved.sphere.center);
        let radius = quantity(solved.sphere.radius);
        let given = formula("(a, b, c) = ") + center + formula(", r = ") + radius;
        rest = sheet.at(argument.ray, |sheet| sheet.lines(rest, &[given]));
    }
    let function = formula(&solved.function(numbers));
    let function = match sheet.width {
        Width::Book => function + " … (iii)",
        Width::Slide => function,
    };
    rest = sheet.at(argument.coefficients, |sheet| {
        sheet.lines(rest, &[function])
    });
    let (count, sign) = match solved.test.roots {
        Roots::None => ("no root", " < 0"),
        Roots::Graze(_) | Roots::Linear(_) => ("one root", ""),
        Roots::Two { .. } => ("two roots", " > 0"),
    };
    let said = if numbers {
        let value = parabola::discriminant(&solved.test);
        format!("discriminant {value}{sign}: {count}")
    } else {
        count.into()
    };
    rest = sheet.at(argument.discriminant, |sheet| sheet.lines(rest, &[said]));

    let QuadraticTest { a, c, .. } = solved.test;
    let radius = solved.sphere.radius;
    // c = |o − center|² − r²
    let extent = Extent {
        distance: ((c + radius * radius) / a).max(0.0).sqrt(),
        radius: solved.radius_in_t(),
    };
    let stages = parabola::Stages {
        axes: argument.coefficients,
        curve: argument.discriminant,
        roots: argument.roots,
        verdict: argument.choice,
    };
    parabola::draw(sheet, rest, &solved.test, extent, &stages, numbers);
}
