(expected: 4:5 U word with no code that uses it)
T0101 S500 M3 F.2
G0 X50. Z5.
G54 U1.
M30
