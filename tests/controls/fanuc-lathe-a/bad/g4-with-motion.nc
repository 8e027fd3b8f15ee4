(expected: 4:1 G4 with dimensions in the same block)
T0101 S500 M3 F.2
G0 X52. Z2.
G4 X1. Z-20.
M30
