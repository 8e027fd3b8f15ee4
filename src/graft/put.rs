//! Putting the sheets in.

use std::collections::{BTreeMap, BTreeSet};

use quick_xml::escape::escape;

use crate::finding::Refusal;
use crate::text::{Text, t};
use crate::workbook::address::cell;
use crate::workbook::guard;
use crate::workbook::names::{Role, slug};
use crate::workbook::stamp;
use crate::workbook::stamp::STALE;

use super::book::{Book, Name};
use super::donor::{self, Donor, Opened};
use super::expected::ExpectedBook;
use super::host::{Host, OTHERS, SOURCE, refused, unfit};
use super::marks::{self, mentions};
use super::parts::{CONTENT_TYPES, RELATIONSHIPS, RELS, Relation, folder, kind, normal, relations_of};
use super::rules::*;
use super::sheet::{Title, emptied, moved};
use super::styles::Styles;
use super::tree::Splices;

/// The type of a sheet of cells.
const WORKSHEET: &str = "application/vnd.openxmlformats-officedocument.spreadsheetml.worksheet+xml";
/// What a sheet's parts may be: the kinds of their relationships end so.
const CARRIED: [&str; 3] = ["/drawing", "/chart", "/image"];
/// Names that every sheet has for itself.
const OWN_NAMES: &str = "_xlnm.";
/// How the names of derived values begin.
const DERIVED: &str = "derived_";
/// What stands on a sheet that a build no longer makes.
const EMPTY: &str = "rodete: la última vez no se ha generado esta hoja · the last build did not make this sheet";

/// A sheet that goes in.
#[derive(Debug)]
struct Going {
    /// Its place among the donor's sheets.
    from: usize,
    /// Its place among the host's sheets.
    to: usize,
    name: String,
    /// What it is known by the next time; `None` for a form, which is the engineer's from then on.
    slug: Option<String>,
    part: String,
}

/// New contents, by the names of their parts.
#[derive(Debug, Default)]
struct Added {
    parts: Vec<(String, Vec<u8>)>,
    types: Vec<(String, String)>,
}

impl Added {
    fn part(&mut self, name: String, content: Vec<u8>, kind: Option<&str>) {
        if let Some(kind) = kind {
            self.types.push((name.clone(), kind.to_owned()));
        }
        self.parts.push((name, content));
    }
}

impl Host<'_> {
    /// The workbook with sheets of a donor: its results where it has any, each in the place of the one that was put in before; else its
    /// form. The same input gives the same bytes.
    ///
    /// # Errors
    /// [`Exit::Refused`](crate::finding::Exit::Refused) for names that are taken, [`Exit::Limit`](crate::finding::Exit::Limit) for a
    /// workbook that would become too large.
    pub fn put(mut self, donor: &Donor<'_>) -> Result<Vec<u8>, Refusal> {
        let (mut opened, formats) = donor::open(donor.bytes)?;
        let results = donor.has_results();
        let gone = if results { self.replaced()? } else { BTreeSet::new() };
        let going = self.going(donor, &opened.book, &gone)?;
        let mut styles = Styles::new(self.parts.needed(&self.styles.clone())?, &formats);
        let (mut added, mut titles, mut formulas) = (Added::default(), Vec::new(), String::new());
        let mut taken: BTreeSet<String> =
            self.parts.all().filter(|one| !gone.contains(*one)).map(str::to_owned).collect();
        taken.extend(going.iter().map(|one| normal(&one.part)));
        for one in &going {
            let part = opened.sheets.get(one.from).cloned().unwrap_or_default();
            let text = opened.parts.bytes(&part)?.and_then(|bytes| String::from_utf8(bytes).ok());
            let text = text.ok_or_else(|| unfit(t("una hoja sin parte", "a sheet without a part")))?;
            let moved = moved(&text, &opened.strings, &mut styles);
            // The guard leads to the lists where they stand in the host.
            if one.slug.as_deref() != Some(guard::KEY) {
                formulas.push_str(&moved.formulas);
            }
            titles.push(moved.title);
            added.part(one.part.clone(), moved.text.into_bytes(), Some(WORKSHEET));
            let mut carried =
                SheetTransfer { opened: &mut opened, taken: &mut taken, added: &mut added, host: folder(&self.root) };
            carried.relations(&part, &one.part, one.slug.as_deref().unwrap_or("form"))?;
        }
        left_out(donor, &formulas)?;
        let empty = if results { self.emptied(&going, &mut styles, &mut added) } else { Vec::new() };
        let mut names = self.names(donor, &opened.book, &going, &titles, &empty)?;
        if results {
            let said = |name: &str, text: &str| {
                let (name, formula) = (name.to_owned(), format!("\"{text}\""));
                Name { name, sheet: None, hidden: true, formula }
            };
            names.extend([said(SOURCE, donor.source), said(OTHERS, &self.others(&gone)?)]);
        }
        let ours = |name: &Name| {
            let sheet = name.sheet.filter(|_| name.name.starts_with(OWN_NAMES));
            sheet.is_some_and(|sheet| {
                going.iter().any(|one| one.to == sheet) || empty.iter().any(|(_, index)| *index == sheet)
            })
        };
        self.book.define(&names, ours);
        let (relations, calculation) = self.relate(&opened.book, &going)?;
        let sheets = self.book.sheets.iter().map(|one| one.name.clone());
        let new = going.iter().filter(|one| one.to >= self.sheets.len()).map(|one| one.name.clone());
        let expected: Vec<String> = sheets.chain(new).collect();
        let gone: BTreeSet<String> = gone.into_iter().chain(calculation).collect();
        let [ending, kind] = RELS;
        if self.types.usual(ending).is_none() {
            // Some writers name each part of relationships with its type, and give the ending none.
            let untyped = added.parts.iter().filter(|(part, _)| part.ends_with(ending));
            added.types.extend(untyped.map(|(part, _)| (part.clone(), kind.to_owned())));
        }
        self.types.change(&gone, &added.types);
        let mut changed = BTreeMap::from([
            (self.parts.name(&self.root).unwrap_or_default().to_owned(), self.book.finish()),
            (self.parts.name(&relations_of(&self.root)).unwrap_or_default().to_owned(), relations),
            (self.parts.name(CONTENT_TYPES).unwrap_or_default().to_owned(), self.types.finish()),
        ]);
        if let Some(formats) = styles.finish()? {
            changed.insert(self.parts.name(&self.styles).unwrap_or_default().to_owned(), formats);
        }
        let gone: BTreeSet<String> = gone.iter().filter_map(|part| self.parts.name(part)).map(str::to_owned).collect();
        let bytes = self.parts.package.changed(&gone, &changed, &added.parts)?;
        let edited = changed.keys().chain(&gone).map(|name| normal(name)).collect();
        let placed: Vec<&str> = going.iter().map(|one| one.name.as_str()).collect();
        let added: Vec<&str> = added.parts.iter().map(|(part, _)| part.as_str()).collect();
        ExpectedBook {
            host: &mut self.parts,
            donor: donor.bytes,
            edited,
            sheets: &expected,
            placed: &placed,
            added: &added,
        }
        .judge(&bytes)?;
        Ok(bytes)
    }

    /// The parts of the sheets that are replaced, and those that only they lead to.
    pub(super) fn replaced(&mut self) -> Result<BTreeSet<String>, Refusal> {
        let ours: BTreeSet<String> = self.ours.values().filter_map(|index| self.sheets.get(*index)).cloned().collect();
        let others = self.parts.reached(&ours)?;
        let (mut gone, mut next): (BTreeSet<String>, Vec<String>) = (BTreeSet::new(), ours.into_iter().collect());
        while let Some(part) = next.pop() {
            for relation in self.parts.relations(&part)?.into_iter().filter(|one| !one.external) {
                if !others.contains(&relation.target) && !gone.contains(&relation.target) {
                    next.push(relation.target);
                }
            }
            gone.insert(normal(&relations_of(&part)));
            gone.insert(part);
        }
        Ok(gone)
    }

    /// The sheets that go in, with their places.
    fn going(&self, donor: &Donor<'_>, book: &Book, gone: &BTreeSet<String>) -> Result<Vec<Going>, Refusal> {
        let mut going: Vec<Going> = Vec::new();
        let mut next = self.sheets.len();
        let free = |part: &str, going: &[Going]| {
            let part = normal(part);
            (gone.contains(&part) || self.parts.name(&part).is_none())
                && going.iter().all(|one| normal(&one.part) != part)
        };
        for one in donor.sheets {
            let from = book.sheets.iter().position(|sheet| sheet.name == one.name);
            let from = from.ok_or_else(|| unfit(t("una hoja que no se escribió", "a sheet that was not written")))?;
            let slug = match &one.role {
                Role::Form if donor.has_results() => continue,
                Role::Form => None,
                Role::Result(key) => Some(slug(key)),
            };
            let there = slug.as_ref().and_then(|slug| self.ours.get(slug)).copied();
            let old = there.and_then(|index| self.sheets.get(index)).and_then(|part| self.parts.name(part));
            let to = there.unwrap_or(next);
            let part = old.map_or_else(
                || {
                    let stem = format!("{}worksheets/rodete-{}", folder(&self.root), slug.as_deref().unwrap_or("form"));
                    first_free(&stem, ".xml", |part| free(part, &going))
                },
                |part| part.replace('\\', "/"),
            );
            if there.is_none() {
                next += 1;
                let taken = self.book.sheets.iter().any(|sheet| sheet.name.to_lowercase() == one.name.to_lowercase());
                if taken {
                    return Err(refused(&SheetNameTaken { sheet: one.name.clone() }));
                }
            }
            going.push(Going { from, to, name: one.name.clone(), slug, part });
        }
        Ok(going)
    }

    /// Empties the sheets that were put in before and are no longer made; gives their slugs and places.
    fn emptied(&self, going: &[Going], styles: &mut Styles<'_>, added: &mut Added) -> Vec<(String, usize)> {
        let made = |slug: &String| going.iter().any(|one| one.slug.as_ref() == Some(slug));
        let empty: Vec<(String, usize)> =
            self.ours.iter().filter(|(slug, _)| !made(slug)).map(|(slug, index)| (slug.clone(), *index)).collect();
        for (_, index) in &empty {
            let Some(part) = self.sheets.get(*index).and_then(|part| self.parts.name(part)) else { continue };
            let text = emptied(EMPTY, styles.format(0));
            added.part(part.replace('\\', "/"), text.into_bytes(), Some(WORKSHEET));
        }
        empty
    }

    /// The names that the sheets need.
    fn names(
        &self,
        donor: &Donor<'_>,
        book: &Book,
        going: &[Going],
        titles: &[Title],
        empty: &[(String, usize)],
    ) -> Result<Vec<Name>, Refusal> {
        let mut names = Vec::new();
        for (one, title) in going.iter().zip(titles) {
            names.extend(one.slug.iter().flat_map(|slug| marks::names(slug, &one.name, title)));
        }
        for (slug, index) in empty {
            let sheet = self.book.sheets.get(*index).map_or("", |one| one.name.as_str());
            names.extend(marks::names(slug, sheet, &Title::Text(EMPTY.to_owned())));
        }
        let mut forms = Vec::new();
        for name in &book.names {
            if let Some(sheet) = name.sheet {
                let to = going.iter().find(|one| one.from == sheet).map(|one| one.to);
                names.extend(to.map(|to| Name { sheet: Some(to), ..name.clone() }));
                continue;
            }
            let out = book.sheets.iter().enumerate().any(|(index, sheet)| {
                going.iter().all(|one| one.from != index) && mentions(&name.formula, &sheet.name)
            });
            if out {
                continue;
            }
            match self.taken(&name.name) {
                Some(there) => forms.push(there),
                None => names.push(name.clone()),
            }
        }
        if let Some(first) = forms.first() {
            if donor.has_results() {
                // The guard's name leads to its cell; a name of the engineer's may be called the same and lead anywhere.
                let guarded = self.book.global(STALE).and_then(|name| cell(&name.formula));
                let built = self.ours.is_empty() && guarded.is_some_and(|(_, at)| at == guard::COUNT);
                return Err(if built { refused(&ResultsThere {}) } else { taken(first) });
            }
            // A form's own row of that name says that it is one.
            let form = self.book.global("schema").and_then(|name| cell(&name.formula));
            return Err(form.map_or_else(|| taken(first), |(sheet, _)| refused(&FormThere { sheet })));
        }
        for (name, formula) in &donor.inputs {
            match self.book.global(name) {
                Some(there) if lost(there) => {}
                Some(there) if cell(&there.formula) == cell(formula) => continue,
                Some(there) => return Err(taken(there)),
                None => {}
            }
            let name = Name { name: (*name).to_owned(), sheet: None, hidden: false, formula: formula.clone() };
            names.push(name);
        }
        let wanted = names.iter().filter(|name| name.sheet.is_none()).map(|name| name.name.to_lowercase());
        let wanted: Vec<String> = wanted.collect();
        self.no_table(|table| wanted.iter().any(|name| name == table))?;
        Ok(names)
    }

    /// Refuses a workbook with a table that is called as a name is to be.
    fn no_table(&self, wanted: impl Fn(&str) -> bool) -> Result<(), Refusal> {
        let found = self.tables.iter().find(|[name, _]| wanted(&name.to_lowercase()));
        found.map_or(Ok(()), |[name, range]| {
            Err(refused(&DefinedNameTaken { name: name.clone(), formula: crate::escape::excerpt(range, 80) }))
        })
    }

    /// The workbook's own name that is called so and leads somewhere else than to our sheets.
    fn taken(&self, name: &str) -> Option<&Name> {
        let mut ours = self.ours.values().filter_map(|index| self.book.sheets.get(*index));
        let there = self.book.global(name).filter(|there| !lost(there))?;
        // One that leads to a sheet that is gone leads nowhere.
        let leads = cell(&there.formula).is_none_or(|(sheet, _)| self.book.sheets.iter().any(|one| one.name == sheet));
        (leads && !ours.any(|sheet| mentions(&there.formula, &sheet.name))).then_some(there)
    }

    /// Refuses a workbook that has a name of its own where results will need one.
    ///
    /// # Errors
    /// [`Exit::Refused`](crate::finding::Exit::Refused) for the first name that is taken.
    pub fn has_room_for_results(&self) -> Result<(), Refusal> {
        let ours = |name: &str| name == STALE || name == stamp::NAME || name.starts_with(DERIVED);
        let names = self.book.names.iter().filter(|one| one.sheet.is_none() && ours(&one.name.to_lowercase()));
        names.filter_map(|one| self.taken(&one.name)).next().map_or(Ok(()), |there| Err(taken(there)))?;
        self.no_table(ours)
    }

    /// Lists the new sheets; gives the part of relationships with theirs, and the parts that hold the order of calculation.
    fn relate(&mut self, donor: &Book, going: &[Going]) -> Result<(Vec<u8>, Vec<String>), Refusal> {
        let (text, root) = self.parts.needed(&relations_of(&self.root))?;
        let mut splices = Splices::default();
        let (mut new, mut listed, mut calculation) = (String::new(), Vec::new(), Vec::new());
        for (element, relation) in root.children.iter().zip(&self.relations) {
            if relation.kind.ends_with(kind::CALC_CHAIN) {
                splices.replace(element.outer.clone(), "");
                calculation.push(relation.target.clone());
            }
        }
        let mut number = 0;
        for one in going.iter().filter(|one| one.to >= self.sheets.len()) {
            let id = loop {
                number += 1;
                let id = format!("rId{number}");
                if self.relations.iter().all(|one| one.id != id) {
                    break id;
                }
            };
            let prefix = root.prefix();
            new.push_str(&format!(
                "<{prefix}Relationship Id=\"{id}\" Type=\"{RELATIONSHIPS}{}\" Target=\"/{}\"/>",
                kind::WORKSHEET,
                one.part
            ));
            let state = donor.sheets.get(one.from).and_then(|sheet| sheet.state.clone());
            listed.push((one.name.clone(), state, id));
        }
        if !new.is_empty() {
            splices.append(&root, &new);
        }
        self.book.add_sheets(&listed);
        Ok((splices.apply(&text).into_bytes(), calculation))
    }
}

/// Judges that no formula leads to a sheet of the donor that stays out: there is another one of its name, laid out otherwise.
fn left_out(donor: &Donor<'_>, formulas: &str) -> Result<(), Refusal> {
    let mut out = donor.sheets.iter().filter(|one| donor.has_results() && one.role == Role::Form);
    match out.find(|one| mentions(formulas, &one.name)) {
        Some(_) => Err(unfit(t("una fórmula que lleva a un formulario", "a formula that leads to a form"))),
        None => Ok(()),
    }
}

/// True for a name that leads to what was deleted.
fn lost(name: &Name) -> bool {
    name.formula.contains("#REF!")
}

fn taken(name: &Name) -> Refusal {
    let formula = crate::escape::excerpt(&name.formula, 80);
    refused(&DefinedNameTaken { name: name.name.clone(), formula })
}

/// The first name of a stem, then of stem and number, that is free.
fn first_free(stem: &str, ending: &str, free: impl Fn(&str) -> bool) -> String {
    let first = format!("{stem}{ending}");
    if free(&first) {
        return first;
    }
    let mut number = 2_u64;
    loop {
        let next = format!("{stem}-{number}{ending}");
        if free(&next) {
            return next;
        }
        number += 1;
    }
}

/// What a sheet leads to, on its way.
struct SheetTransfer<'c, 'd> {
    opened: &'c mut Opened<'d>,
    taken: &'c mut BTreeSet<String>,
    added: &'c mut Added,
    /// The folder of the host's workbook part.
    host: &'c str,
}

impl SheetTransfer<'_, '_> {
    /// Carries all that a part of the donor leads to; `into` is the part's new name.
    fn relations(&mut self, part: &str, into: &str, slug: &str) -> Result<(), Refusal> {
        let relations = self.opened.parts.relations(part)?;
        if relations.is_empty() {
            return Ok(());
        }
        let mut text = String::from(
            "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n\
             <Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">",
        );
        for Relation { id, kind, target, external } in relations {
            let (target, mode) = if external {
                (escape(&target).into_owned(), " TargetMode=\"External\"")
            } else {
                (format!("/{}", self.carry(&kind, &target, slug)?), "")
            };
            text.push_str(&format!("<Relationship Id=\"{id}\" Type=\"{kind}\" Target=\"{target}\"{mode}/>"));
        }
        text.push_str("</Relationships>");
        self.added.part(relations_of(into), text.into_bytes(), None);
        Ok(())
    }

    /// Carries a part, and all that it leads to; gives its new name.
    fn carry(&mut self, kind: &str, part: &str, slug: &str) -> Result<String, Refusal> {
        if !CARRIED.iter().any(|one| kind.ends_with(one)) {
            return Err(unfit(Text::same(part)));
        }
        let content = self.opened.parts.bytes(part)?.ok_or_else(|| unfit(Text::same(part)))?;
        let folder = folder(part).split_once('/').map_or("", |(_, folder)| folder);
        let ending = part.rfind('.').and_then(|dot| part.get(dot..)).unwrap_or_default();
        let name = first_free(&format!("{}{folder}rodete-{slug}", self.host), ending, |name| {
            !self.taken.contains(&normal(name))
        });
        self.taken.insert(normal(&name));
        let type_of = self.opened.types.of_part(part).map(str::to_owned);
        self.added.part(name.clone(), content, type_of.as_deref());
        self.relations(part, &name, slug)?;
        Ok(name)
    }
}
