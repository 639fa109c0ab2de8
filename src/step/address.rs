//! A step by the numbers of the log: `37`, `#80,60:37`, `#path17:37`, `#building:37`.

use std::fmt;
use std::str::FromStr;

use crate::explain::{Section, StepAddress};
use crate::step::tree::StepLog;

/// An event by its section and its `step` in the log.
///
/// `37` is a step of the pixel itself. With several pixels it is `#80,60:37`, on a path of light `#path17:37`, and while the
/// structure is built `#building:37`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Address {
    /// The pixel, if it was named.
    pub pixel: Option<[u32; 2]>,
    /// The section and the step.
    pub at: StepAddress,
}

impl Address {
    /// The address of an event, without the pixel.
    pub fn of(log: &StepLog, event: usize) -> Self {
        Self {
            pixel: None,
            at: StepAddress::of(&log.records[event]),
        }
    }
}

impl fmt::Display for Address {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let step = self.at.step;
        match (self.at.section, self.pixel) {
            (Section::Pixel, None) => write!(f, "{step}"),
            (Section::Pixel, Some([x, y])) => write!(f, "#{x},{y}:{step}"),
            (Section::Path(path), _) => write!(f, "#path{path}:{step}"),
            (Section::Building, _) => write!(f, "#building:{step}"),
        }
    }
}

/// Why an address leads nowhere.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum AddressError {
    /// It is none.
    Form(String),
    /// The log has no such section.
    NoSection(Address),
    /// The section has no such step.
    NoStep {
        /// The address.
        address: Address,
        /// The last step of the section.
        last: u32,
    },
}

impl std::error::Error for AddressError {}

impl fmt::Display for AddressError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Form(text) => write!(
                f,
                "{text:?} is no step: give its number in the log, such as 37, #80,60:37, #path17:37 or #building:37"
            ),
            Self::NoSection(address) => {
                write!(
                    f,
                    "there is no step {address}: this log has no such section"
                )
            }
            Self::NoStep { address, last } => {
                write!(f, "there is no step {address}: the last one is {last}")
            }
        }
    }
}

impl FromStr for Address {
    type Err = AddressError;

    fn from_str(text: &str) -> Result<Self, AddressError> {
        let wrong = || AddressError::Form(text.into());
        let (of, step) = match text.strip_prefix('#') {
            None => (None, text),
            Some(rest) => {
                let (of, step) = rest.split_once(':').ok_or_else(wrong)?;
                (Some(of), step)
            }
        };
        let number = |digits: &str| -> Option<u32> {
            let is_number = digits.bytes().all(|byte| byte.is_ascii_digit());
            digits.parse().ok().filter(|_| is_number)
        };
        let step = number(step).ok_or_else(wrong)?;
        let mut pixel = None;
        let section = match of {
            None => Section::Pixel,
            Some("building") => Section::Building,
            Some(of) => match (of.strip_prefix("path"), of.split_once(',')) {
                (Some(path), _) => Section::Path(number(path).ok_or_else(wrong)?),
                (None, Some((x, y))) => {
                    pixel = Some([number(x).ok_or_else(wrong)?, number(y).ok_or_else(wrong)?]);
                    Section::Pixel
                }
                (None, None) => return Err(wrong()),
            },
        };
        let at = StepAddress { section, step };
        Ok(Self { pixel, at })
    }
}

impl StepLog<'_> {
    /// The place of an event among the records.
    ///
    /// # Errors
    /// The log has no such section, or no such step: it may have been filtered.
    pub fn event_at(&self, address: Address) -> Result<usize, AddressError> {
        let of_section = |&number: &usize| {
            let first = &self.records[self.step(number).events.start];
            StepAddress::of(first).section == address.at.section
        };
        let section = self.sections().find(of_section);
        let events = section.map(|number| self.step(number).events.clone());
        let events = events.ok_or(AddressError::NoSection(address))?;
        let records = &self.records[events.clone()];
        let place = records.partition_point(|record| record.step < address.at.step);
        match records.get(place) {
            Some(record) if record.step == address.at.step => Ok(events.start + place),
            _ => Err(AddressError::NoStep {
                address,
                last: records.last().map_or(0, |record| record.step),
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_address_is_read_as_it_is_printed() {
        for text in ["37", "0", "#80,60:37", "#path17:3", "#building:12"] {
            let address: Address = text.parse().unwrap();
            assert_eq!(address.to_string(), text);
        }
        let address: Address = "#80,60:37".parse().unwrap();
        assert_eq!((address.pixel, address.at.step), (Some([80, 60]), 37));
    }

    #[test]
    fn what_is_no_address_is_refused_with_its_forms() {
        for text in [
            "",
            "-1",
            "+1",
            "x",
            "#",
            "#37",
            "#:3",
            "#80:3",
            "#80,:3",
            "#path:3",
            "#pathx:1",
            "#80,60:",
            "4294967296",
            "#80,60:1:2",
        ] {
            let error = text.parse::<Address>().unwrap_err();
            assert_eq!(error, AddressError::Form(text.into()));
            assert!(error.to_string().contains("#path17:37"), "{error}");
        }
    }
}
