;expected: 5:8 G53 with Z and a tool length offset in force
G71 G90 G94 F100
T1 D1
G43 G0 Z50
G53 G0 Z0
M30
