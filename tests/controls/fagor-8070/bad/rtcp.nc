;expected: 3:1 statements of Fagor's high-level language: it cannot verify this program
%P
#RTCP ON
G71 G90 G94 F100
G1 X10
M30
