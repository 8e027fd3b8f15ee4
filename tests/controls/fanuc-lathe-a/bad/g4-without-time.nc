(expected: 4:1 G4 without a time)
T0101 S500 M3 F.2
G0 X50. Z5.
G4
M30
