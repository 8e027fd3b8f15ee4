//! What is wrong with expressions, parameters, inputs and outputs.

use crate::finding::Example;
use crate::finding::rule::rules;

rules! {
    /// The rows of this file.
    RULES;

    "G0201" NotFinite Stop {}
        es "el resultado no es un número finito"
        en "the result is not a finite number"
        remedy "corrija la expresión", "correct the expression";
        why "Un número sin fin no es una posición.",
            "A number without bound is no position.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X[10**400]|M2", "2:8");
    "G0202" NegativePower Stop {}
        es "potencia no entera de un número negativo"
        en "negative number to a power that is not whole"
        remedy "corrija la expresión", "correct the expression";
        why "Ese número no existe entre los que mide una máquina.",
            "There is no such number among those that a machine measures.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X[[0-2]**0.5]|M2", "2:11");
    "G0203" DivisionByZero Stop {}
        es "división por cero"
        en "division by zero"
        remedy "corrija la expresión", "correct the expression";
        why "El resultado no existe, y el control se para.",
            "There is no result, and the control stops.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X[1/0]|M2", "2:7");
    "G0204" TwoSigns Stop {}
        es "número con dos signos"
        en "number with two signs"
        remedy "deje un solo signo", "leave one sign";
        why "No se sabe si los dos signos se quieren o uno sobra.",
            "Nothing says whether both signs are meant or one is left over.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X--1|M2", "2:5");
    "G0205" TooDeep Stop { most: usize }
        es "expresión con más de {most} niveles"
        en "expression nested more than {most} deep"
        remedy "divídala con parámetros", "split it with parameters";
        why "El control tampoco guarda más niveles abiertos.",
            "The control does not hold more open levels either.";
        example Example::program("linuxcnc", "G0 X[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[1]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]|M2", "1:69");
    "G0206" BracketMissing Stop {}
        es "falta «[»"
        en "'[' is missing"
        remedy "ponga la expresión entre corchetes", "put the expression in brackets";
        why "Sin corchetes no se sabe dónde empieza y acaba la condición.",
            "Without brackets nothing says where the condition begins and ends.";
        example Example::program("linuxcnc", "G21 G90 F100|O1 IF 1|O1 ENDIF|M2", "2:6");
    "G0207" ExpressionOpen Stop {}
        es "expresión sin cerrar"
        en "unclosed expression"
        remedy "ciérrela con «]»", "close it with ']'";
        why "Sin el cierre no se sabe dónde acaba la expresión.",
            "Without its end nothing says where the expression stops.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X[1+2|M2", "2:5");
    "G0208" OperatorUnknown Stop {}
        es "operador desconocido"
        en "unknown operator"
        remedy "corrija la expresión", "correct the expression";
        why "Sin un operador conocido no hay resultado.",
            "Without an operator that is known there is no result.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X[1 foo 2]|M2", "2:7");
    "G0209" FunctionUndefined Stop { function: String, argument: f64 }
        es "{function} no está definida para {argument}"
        en "{function} is not defined for {argument}"
        remedy "corrija la expresión", "correct the expression";
        why "Fuera de su dominio la función no tiene valor, y el control se para.",
            "Outside its domain the function has no value, and the control stops.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X[ACOS[2]]|M2", "2:6");
    "G0210" AtanWithoutSlash Stop {}
        es "falta «/» en ATAN[y]/[x]"
        en "'/' is missing in ATAN[y]/[x]"
        remedy "escriba ATAN[y]/[x]", "write ATAN[y]/[x]";
        why "ATAN necesita las dos coordenadas para saber el cuadrante.",
            "ATAN needs both coordinates to know the quadrant.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X[ATAN[1]]|M2", "2:13");
    "G0211" Exists Stop {}
        es "EXISTS espera un parámetro: EXISTS[#<nombre>]"
        en "EXISTS wants a parameter: EXISTS[#<name>]"
        remedy "escriba EXISTS[#<nombre>]", "write EXISTS[#<name>]";
        why "EXISTS pregunta por un parámetro, no por un valor.",
            "EXISTS asks for a parameter, not for a value.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X[EXISTS[1]]|M2", "2:12");
    "G0212" NameUnset Stop { name: String }
        es "el parámetro #<{name}> no está definido"
        en "parameter #<{name}> is not defined"
        remedy "dele un valor antes de usarlo", "give it a value before it is used";
        why "Un parámetro con nombre no tiene valor hasta que se le da.",
            "A named parameter has no value until it is given one.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X#<nowhere>|M2", "2:5");
    "G0213" InputUsed Stop { number: usize }
        es "#{number} es lo que M66 ha leído de una entrada: no está en el programa"
        en "#{number} is what M66 has read of an input: it is not in the program"
        remedy "para comprobar el programa, ponga en su lugar el valor que se espera", "to verify the program, put the value that is expected in its place";
        why "Lo que lea la entrada decide el programa, y aquí no se puede saber.",
            "What the input reads decides the program, and it cannot be known here.";
        example Example::program("linuxcnc", "G21 G90 F100|M66 P0|G0 X#5399|M2", "3:5");
    "G0214" ParameterUnset Caution { number: usize }
        es "el parámetro #{number} no tiene valor: vale 0"
        en "parameter #{number} was never set: it counts as 0"
        remedy "dele un valor antes de usarlo", "give it a value before it is used";
        why "Si el control guarda en él un valor de antes, el programa hace otra cosa.",
            "Where the control keeps a value of before in it, the program does something else.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X#31|M2", "2:5");
    "G0215" EqualsMissing Stop {}
        es "falta «=» detrás del parámetro"
        en "'=' is missing after the parameter"
        remedy "escriba #1=2", "write #1=2";
        why "Un parámetro al principio de una palabra solo puede recibir un valor.",
            "A parameter at the beginning of a word can only be given a value.";
        example Example::program("linuxcnc", "G21 G90 F100|#1 X2|M2", "2:4");
    "G0216" ValueMissing Stop {}
        es "falta un valor delante de «]»"
        en "a value is missing before ']'"
        remedy "complete la expresión", "complete the expression";
        why "A la expresión le falta el último de sus valores.",
            "The expression lacks the last of its values.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X[1+]|M2", "2:8");
    "G0217" FunctionUnknown Stop {}
        es "función desconocida"
        en "unknown function"
        remedy "use ABS, ACOS, ASIN, ATAN, COS, EXISTS, EXP, FIX, FUP, LN, ROUND, SIN, SQRT o TAN", "use ABS, ACOS, ASIN, ATAN, COS, EXISTS, EXP, FIX, FUP, LN, ROUND, SIN, SQRT or TAN";
        why "Una función mal escrita no da ningún número.",
            "A misspelt function gives no number.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X[SINE[1]]|M2", "2:6");
    "G0218" ParameterOutOfRange Stop { number: f64, most: usize }
        es "no hay parámetro #{number}"
        en "there is no parameter #{number}"
        remedy "use #1 a #{most}", "use #1 to #{most}";
        why "El control no tiene ese parámetro y se para.",
            "The control has no such parameter and stops.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X#5602|M2", "2:5");
    "G0219" ParameterReadOnly Stop { name: String }
        es "el parámetro {name} es de solo lectura"
        en "parameter {name} is read-only"
        remedy "use otro parámetro", "use another parameter";
        why "El control lo calcula él mismo y no deja cambiarlo.",
            "The control computes it itself and does not let it be changed.";
        example Example::program("linuxcnc", "G21 G90 F100|#5420=1|M2", "2:1");
}
