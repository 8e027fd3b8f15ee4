;expected: 6:8 incremental Z while the tool's length is still to be taken up
G71 G90 G94 F100
T1 D1
M6
G43
G91 G0 Z5
M30
