;expected: 4:1 G4 without a time
G71 G90 G94 F100
G0 X1
G4 X5
M30
