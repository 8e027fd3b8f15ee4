//! Slips of the printed source, each with the form that its own tables need.
//!
//! Every row is proved by a test of the same name in `tests/kinds/slips.rs`: the printed form fails against the published
//! figures, ours holds.
//!
//! | where | printed | what the tables need | test |
//! |---|---|---|---|
//! | equation 5 | cos α·z + sin α·x = 0 | cos α·z − sin α·x = 0 | `equation_5_sign_of_the_plane` |
//! | equation 6 | u = arccos(…) | holds up to u = π only; beyond it u = 2π − arccos(…) | `equation_6_arccosine_beyond_pi` |
//! | equation 7 | C = arctan(N_x/N_y) | C = atan2(N_y, N_x), continuous | `equation_7_arctangent_of_c` |
//! | equations 8–12 | rotation by +C | rotation by −C | `equations_8_to_12_sense_of_c` |
//! | equation 14 | B = arctan(N′_z/N′_x) | B = atan2(N′_x, N′_z) | `equation_14_arctangent_of_b` |
//! | equation 16 | no pivot length | rotation about the pivot at the distance L | `equation_16_pivot_length` |
//! | annex 5 | – | L = 233.95 there, 242.9 in annexes 6–10, 147.5 (spindle height alone) in the text | `annex_5_has_its_own_pivot_length` |
//! | equations 20, 21 | obverse −b″, reverse +b″ | obverse +b″, reverse −b″ | `equations_20_and_21_sides` |
//! | equations 23, 28 | β = ratio | tan β = ratio | `equations_23_and_28_tangent` |
//! | equations 24–27 | positive increments | negative at the entry | `equations_24_to_27_sign_at_the_entry` |
//! | equation 39 | 2(b − a); the term z0 without its factor E | 2(a + b); E·z0 | `equation_39_sum_of_a_and_b` |
//! | table of 4.1 | Z = −R | Z = −r, as the program has it | `table_of_4_1_start_of_the_profile` |
//! | section 4.3 | the offset grows linearly | fraction ((j+1)/(m+1))⁵ | `section_4_3_fifth_power` |
//! | annex 9, N460–N850 | the reverse forwards, with the obverse's signs: the tool leaves by (535.796, 0, 435.797) mm, −180° and 343.742° and does not come back | backwards, signs changed | `annex_9_reverse_path_leaves` |
//! | annex 9 | N30–N420 rounded, then subtracted; N460–N850 subtracted, then rounded | one rule: round, then subtract | `annex_9_has_two_rounding_rules` |
//! | annex 10 | starts with Y4, ends with Y0: each run shifts the part by 3.998 mm in Y | ends where it started | `annex_10_shifts_the_part` |
