//! Expressions by chance.

use proptest::prelude::*;

/// Operators as they are written; what binds how is the interpreters' affair.
const OPERATORS: [&str; 17] = [
    "+", "-", "*", "/", "**", " mod ", " MOD ", " eq ", " ne ", " gt ", " ge ", " lt ", " le ", " and ", " or ",
    " xor ", " - ",
];
/// Functions that any processor computes to the last digit.
const EXACT: [&str; 6] = ["abs", "fix", "fup", "round", "sqrt", "ABS"];
const TRANSCENDENTAL: [&str; 8] = ["sin", "cos", "tan", "asin", "acos", "exp", "ln", "SIN"];

/// Chains of operators, brackets and exact functions over small numbers and parameters.
fn exact() -> impl Strategy<Value = String> {
    let leaf = prop_oneof![
        4 => (0..10_u8).prop_map(|digit| digit.to_string()),
        2 => (0..100_u8).prop_map(|tenths| format!("{}.{}", tenths / 10, tenths % 10)),
        1 => (1..10_u8).prop_map(|digit| format!("-{digit}")),
        2 => prop::sample::select(vec!["#1", "#2", "#<a>", "#<_bb>", "##3", "#[1+1]", "-#1"]).prop_map(str::to_owned),
    ];
    leaf.prop_recursive(3, 24, 5, |inner| {
        prop_oneof![
            5 => prop::collection::vec((inner.clone(), prop::sample::select(OPERATORS.to_vec())), 2..6).prop_map(|chain| {
                let last = chain.len() - 1;
                let terms: String = chain
                    .into_iter()
                    .enumerate()
                    .map(|(at, (term, operator))| term + if at == last { "" } else { operator })
                    .collect();
                format!("[{terms}]")
            }),
            1 => (prop::sample::select(EXACT.to_vec()), inner.clone()).prop_map(|(f, inner)| format!("{f}[{inner}]")),
            1 => (inner.clone(), inner).prop_map(|(a, b)| format!("atan[{a}]/[{b}]")),
        ]
    })
}

/// One expression, some of them with a transcendental function around it.
fn expression() -> impl Strategy<Value = String> {
    prop_oneof![
        3 => exact(),
        // No powers: of a great angle the last digit decides the sine.
        1 => (prop::sample::select(TRANSCENDENTAL.to_vec()), exact().prop_filter("no powers", |inner| !inner.contains("**")))
            .prop_map(|(f, inner)| format!("{f}[{inner}]")),
    ]
}

prop_compose! {
    /// A program that moves X by an expression in each of its blocks.
    pub fn programs()(expressions in prop::collection::vec(expression(), 1..6)) -> String {
        let blocks: String = expressions.into_iter().map(|expression| format!("X[{expression}]\n")).collect();
        format!("G21 G90\n#1=3 #2=-2.5 #3=1 #<a>=0.5 #<_bb>=7\nG0\n{blocks}M2\n")
    }
}
