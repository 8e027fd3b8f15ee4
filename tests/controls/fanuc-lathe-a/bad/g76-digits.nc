(expected: 5:1 P1010060 in the first block of G76 does not have six digits)
T0101 S500 M3 F.2
G0 X50. Z5.
G76 P1010060 Q50 R.1
G76 X28. Z-20. P1000 Q300 F1.5
M30
