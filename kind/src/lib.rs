//! `#[kind]`: plain data of a scene file.
//!
//! ```text
//! #[kind(PartialEq)]
//! pub struct ThinLens {
//!     /// The distance of the view plane.
//!     pub distance: Distance,
//!     /// Where a stop lies, if there is one.
//!     pub stop: Option<Distance>,
//!     /// The magnification; positive.
//!     #[default(1.0)]
//!     pub zoom: Positive,
//!     /// Whether the picture is upside down.
//!     #[optional]
//!     pub inverted: bool,
//! }
//! ```
//!
//! A struct is read, written and described, and refuses unknown fields. The type of a field says its
//! range (the names in `RANGES`): `check_ranges` names the first field outside it, and the schema
//! says which numbers are lengths. A field is required, but
//!
//! - `Option`: may be left out, and is not written where it is `None`;
//! - `#[default]`, `#[default(1.0)]`: may be left out, and is written always;
//! - `#[optional]`, `#[optional(true)]`: may be left out, and is not written where it has its default.
//!
//! A list of fixed length has exactly that length. An enum is read and written by the names of its
//! variants in snake case. The arguments are further traits to derive; `Default` has the defaults of
//! the fields. Attributes of serde and schemars can stand beside these.

use proc_macro::TokenStream;
use proc_macro2::{Ident, TokenStream as Tokens};
use quote::{format_ident, quote};
use syn::punctuated::Punctuated;
use syn::{Data, DeriveInput, Field, Fields, GenericArgument, Meta, PathArguments, Token, Type};
use syn::{parse_macro_input, parse_quote};

/// The types of `groundtruth::math` that say a range, the function of `groundtruth::invalid` that
/// checks it, and whether the schema has to say that they are lengths.
const RANGES: [(&str, &str, bool); 12] = [
    ("Coordinate", "finite", true),
    ("Displacement", "finite_vector", true),
    ("Distance", "positive", true),
    ("Finite", "finite", false),
    ("Index", "index", false),
    ("Length", "length", true),
    ("NonNegative", "not_negative", false),
    ("Point", "finite_point", false),
    ("Positive", "positive", false),
    ("Share", "share", false),
    ("Strength", "strength", false),
    ("Width", "not_negative", true),
];

/// Plain data of a scene file: see the head of this file.
#[proc_macro_attribute]
pub fn kind(further: TokenStream, item: TokenStream) -> TokenStream {
    let further = parse_macro_input!(further with Punctuated::<Ident, Token![,]>::parse_terminated);
    let mut item = parse_macro_input!(item as DeriveInput);
    let name = item.ident.clone();
    let mut traits =
        quote!(Clone, Debug, ::serde::Serialize, ::serde::Deserialize, ::schemars::JsonSchema);
    let is_struct = matches!(item.data, Data::Struct(_));
    let derived = further.iter().filter(|it| !is_struct || *it != "Default");
    traits.extend(quote!(#(, #derived)*));
    let (form, also) = match &mut item.data {
        Data::Enum(data) => {
            if data.variants.iter().all(|variant| variant.fields.is_empty()) {
                traits.extend(quote!(, Copy, PartialEq, Eq));
            }
            (quote!(#[serde(rename_all = "snake_case")]), Tokens::new())
        }
        Data::Struct(data) => {
            let of_structs =
                of_struct(&mut data.fields, &name, further.iter().any(|it| it == "Default"));
            (quote!(#[serde(deny_unknown_fields)]), of_structs)
        }
        Data::Union(_) => panic!("a union is no plain data"),
    };
    quote!(#[derive(#traits)] #form #item #also).into()
}

/// Writes the fields' attributes as serde and schemars know them, and what a struct has besides:
/// its check, the functions that the attributes name, and its default if it has one.
fn of_struct(fields: &mut Fields, name: &Ident, has_default: bool) -> Tokens {
    let (mut checks, mut functions, mut values) = (Tokens::new(), Tokens::new(), Tokens::new());
    for field in fields {
        let it = field.ident.clone().expect("a field of plain data has a name");
        let own = defaults(field, &it, name);
        checks.extend(check(field, &it, own.is_some()));
        let value = format_ident!("default_{it}");
        values.extend(match own {
            Some(_) => quote!(#it: Self::#value(),),
            None => quote!(#it: ::core::default::Default::default(),),
        });
        functions.extend(own);
    }
    let default = has_default.then(|| {
        quote! {
            impl ::core::default::Default for #name {
                fn default() -> Self {
                    Self { #values }
                }
            }
        }
    });
    quote! {
        impl crate::invalid::Ranges for #name {
            fn check_ranges(&self) -> Result<(), crate::invalid::Invalid> {
                #checks
                Ok(())
            }
        }

        impl #name {
            #functions
        }

        #default
    }
}

/// The check of a field's range; writes the attributes that follow from its type.
fn check(field: &mut Field, it: &Ident, has_default: bool) -> Option<Tokens> {
    let within_option = argument(&field.ty, "Option");
    let of_rows = within_option.and_then(|ty| argument(ty, "Vec"));
    let reader = match (&field.ty, within_option, of_rows) {
        (Type::Array(_), ..) => Some("crate::math::lists::exactly"),
        (_, Some(Type::Array(_)), _) => Some("crate::math::lists::exactly_if_any"),
        (_, _, Some(Type::Array(_))) => Some("crate::math::lists::of_rows_if_any"),
        _ => None,
    };
    let range = range(within_option.unwrap_or(&field.ty));
    let check = range.map(|(_, check, _)| {
        let (check, text) = (format_ident!("{check}"), it.to_string());
        match within_option {
            Some(_) => quote!(if let Some(it) = self.#it { crate::invalid::#check(#text, it)?; }),
            None => quote!(crate::invalid::#check(#text, self.#it)?;),
        }
    });
    if within_option.is_some() && !has_default {
        field.attrs.push(parse_quote!(#[serde(default, skip_serializing_if = "Option::is_none")]));
    }
    if let Some(reader) = reader {
        field.attrs.push(parse_quote!(#[serde(deserialize_with = #reader)]));
    }
    if range.is_some_and(|(_, _, is_length)| is_length) {
        field.attrs.push(parse_quote!(#[schemars(extend("x-dimension" = "length"))]));
    }
    check
}

/// Writes `#[default]` and `#[optional]` as serde and schemars know them; the functions that their
/// attributes name, if the field has one.
fn defaults(field: &mut Field, it: &Ident, name: &Ident) -> Option<Tokens> {
    let own = |word| field.attrs.iter().position(|attribute| attribute.path().is_ident(word));
    let (default, optional) = (own("default"), own("optional"));
    let given = match field.attrs.remove(default.or(optional)?).meta {
        Meta::List(list) => Some(list.tokens),
        _ => None,
    };
    let value = given.clone().unwrap_or_else(|| quote!(::core::default::Default::default()));
    let (ty, default_of, is_default) =
        (&field.ty, format_ident!("default_{it}"), format_ident!("is_default_{it}"));
    let mut functions = quote!(fn #default_of() -> #ty { #value });
    let path = format!("{name}::{default_of}");
    field.attrs.push(parse_quote!(#[serde(default = #path)]));
    if optional.is_some() {
        functions.extend(quote!(fn #is_default(it: &#ty) -> bool { *it == Self::#default_of() }));
        let path = format!("{name}::{is_default}");
        field.attrs.push(parse_quote!(#[serde(skip_serializing_if = #path)]));
        // schemars leaves out a default that serde does not write
        field
            .attrs
            .extend(given.map(|value| parse_quote!(#[schemars(extend("default" = #value))])));
    }
    Some(functions)
}

/// What the name of a type says of its range.
fn range(ty: &Type) -> Option<(&'static str, &'static str, bool)> {
    let Type::Path(path) = ty else { return None };
    let last = &path.path.segments.last()?.ident;
    RANGES.into_iter().find(|(name, ..)| last == name)
}

/// The type in the brackets of this generic one.
fn argument<'a>(ty: &'a Type, generic: &str) -> Option<&'a Type> {
    let Type::Path(path) = ty else { return None };
    let last = path.path.segments.last().filter(|last| last.ident == generic)?;
    match &last.arguments {
        PathArguments::AngleBracketed(arguments) => match arguments.args.first()? {
            GenericArgument::Type(ty) => Some(ty),
            _ => None,
        },
        _ => None,
    }
}
