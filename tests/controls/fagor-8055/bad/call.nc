;expected: 3:1 it cannot verify this program; write what the statement does as plain blocks
G71 G90 G94 F100
(CALL 1)
M30
