;expected: 3:1 rodete reads 'G4 0.5' as one number
G71 G90 G94 F100
G4 0.5
M30
