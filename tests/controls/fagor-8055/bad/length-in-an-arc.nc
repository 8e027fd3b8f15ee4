;expected: 6:11 arc with Z while the tool's length
G71 G90 G94 F100
T1 D1
M6
G43 G0 X0 Y0
G2 X10 Y0 Z-1 R5
M30
