;expected: 5 motion under G93 without F
%0001-A
N10 G71 G90
N20 G93
N30 G1 X10
N40 M30
