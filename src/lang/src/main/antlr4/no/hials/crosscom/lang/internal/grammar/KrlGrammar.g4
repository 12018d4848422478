/*
 * The lines of KRL: .src, .sub and .dat files (docs/reference/krl-language.md).
 *
 * KRL is line-oriented, so the start rule is a line. FileBuilder combines the lines of a block
 * (DEF ... END, IF ... ENDIF). So an error affects only its line, and a missing ENDIF is one
 * error, not a hundred.
 *
 * The next token decides every choice, except for operators in expressions. So an error is found
 * at the first token that is not allowed in its place.
 *
 * Keywords with a meaning in only one place (SEC, STEP, DISTANCE, ...) are names elsewhere:
 * $DATE.SEC is a component. Types are names too. The tokens without a rule (SPTP, ...) begin a
 * line; see StatementWords. Unsupported statements (ASYPTP, ...) are not part of the grammar.
 */
grammar KrlGrammar;

options {
  caseInsensitive = true;
}

tokens {
  ANIN,
  ANOUT,
  CHANNEL,
  CONFIRM,
  CONST_VEL,
  ENDSPLINE,
  ON_ERROR_PROCEED,
  SCIRC,
  SCIRC_REL,
  SLIN,
  SLIN_REL,
  SPL,
  SPLINE,
  SPL_REL,
  SPTP,
  SPTP_REL,
  STOP,
  TIME_BLOCK
}

line : content? (NEWLINE | EOF) ;

content
  : HEADER
  | modifier+ (definition | variables)
  | definition
  | named
  | dataListBegin
  | end
  | blockBegin
  | blockMiddle
  | blockEnd
  | simpleStatement
  | motion
  | splineMotion
  | pathCommand
  | pulse
  | trigger
  | analog
  ;

// ---- modules and declarations

dataListBegin : DEFDAT name PUBLIC? ;

end : END | ENDFCT | ENDDAT ;

modifier : GLOBAL | DECL | CONST ;

definition
  : routineBegin
  | functionBegin
  | struc
  | enumeration
  | signal
  | channel
  | external
  | externalFunction
  | imported
  | interrupt
  ;

routineBegin : DEF name parameters ;

// A function can return an array, as CHAR[16] (docs/reference/krl-language.md#modules).
functionBegin : DEFFCT name brackets? name parameters ;

parameters : '(' (parameter (',' parameter)*)? ')' ;

parameter : name brackets? (':' (IN | OUT))? ;

variables : name declarator (',' declarator)* ;

declarator : name brackets? ('=' expression)? ;

struc : STRUC name component (',' component)* ;

// A component without a type has the type of the previous component.
component : name name? brackets? ;

enumeration : ENUM name name (',' name)* ;

signal : SIGNAL name (FALSE | variable (TO variable)?) ;

// (docs/reference/krl-language.md#declarations)
channel : CHANNEL ':' name ':' name variable ;

external : EXT name parameters ;

externalFunction : EXTFCT name brackets? name parameters ;

imported : IMPORT name name brackets? IS importPath brackets? ;

// decided by one token each, as the rest: the parser reports errors from that token
importPath : '/' '/'? name ('/' name)* '..' name ;

// ---- statements

// The lines that start with a name: a label, a call, a declaration without DECL, an assignment.
named
  : name
    ( ':'
    | arguments
    | declarator (',' declarator)*
    | steps '=' expression
    )
  ;

blockBegin
  : IF expression THEN
  | SWITCH expression
  | FOR variable '=' expression TO expression (STEP expression)?
  | WHILE expression
  | REPEAT
  | LOOP
  | SPLINE with?
  ;

blockMiddle
  : ELSE
  | CASE expression (',' expression)*
  | DEFAULT
  ;

blockEnd
  : ENDIF
  | ENDSWITCH
  | ENDFOR
  | ENDWHILE
  | UNTIL expression
  | ENDLOOP
  | ENDSPLINE splineApproximation?
  ;

simpleStatement
  : EXIT
  | GOTO name
  | RETURN expression?
  | HALT
  | CONTINUE
  | WAIT (FOR expression | SEC expression)
  | RESUME
  | BRAKE F?
  | ON_ERROR_PROCEED
  | CONFIRM expression
  ;

interrupt
  : INTERRUPT
    ( DECL expression WHEN expression DO action
    | (ON | OFF | ENABLE | DISABLE) expression?
    )
  ;

trigger
  : TRIGGER WHEN (DISTANCE '=' distance=expression | PATH '=' distance=expression ONSTART?)
    (DELAY '=' delay=expression)?
    DO action
    (PRIO '=' priority=expression)?
  ;

action
  : pulse
  | name (arguments | steps '=' expression)
  ;

pulse : PULSE '(' variable ',' expression ',' expression ')' ;

// Assumed: PTP allows C_DIS and the like alone. The others have no C_PTP
// (docs/reference/krl-language.md#motions).
motion
  : (PTP | PTP_REL) expression (anyApproximation anyApproximation?)?
  | LIN expression (pathApproximation pathApproximation?)?
  | LIN_REL expression (pathApproximation pathApproximation?)? ENUM_VALUE?
  | CIRC expression ',' expression (',' CA expression)?
    (pathApproximation pathApproximation?)?
  | CIRC_REL expression ',' expression (',' CA expression)?
    (pathApproximation pathApproximation?)? ENUM_VALUE?
  ;

// Assumed: C_SPL can precede WITH, and C_DIS replace it (docs/reference/krl-language.md#splines).
splineMotion
  : (SPTP | SPTP_REL | SLIN | SPL) expression splineEnd?
  | (SLIN_REL | SPL_REL) expression splineEnd? ENUM_VALUE?
  | SCIRC expression ',' expression (',' CA expression)? splineEnd?
  | SCIRC_REL expression ',' expression (',' CA expression)? splineEnd? ENUM_VALUE?
  ;

splineEnd
  : splineApproximation with?
  | with splineApproximation?
  ;

splineApproximation : C_SPL | C_DIS ;

with : WITH assignment (',' assignment)* ;

assignment : name steps '=' expression ;

// (docs/reference/krl-language.md#splines)
pathCommand
  : TIME_BLOCK (START | (PART | END) '=' expression)
  | CONST_VEL (START | END) '=' expression ONSTART?
  | STOP WHEN PATH '=' expression ONSTART? IF expression
  ;

// Assumed, as all of analogue cycles (docs/reference/krl-language.md#analogue-cycles).
analog
  : ANIN (ON variable '=' expression | OFF variable)
  | ANOUT
    ( ON variable '=' value=expression
      (DELAY '=' delay=expression)?
      (MINIMUM '=' minimum=expression)?
      (MAXIMUM '=' maximum=expression)?
    | OFF variable
    )
  ;

anyApproximation : C_PTP | pathApproximation ;

pathApproximation : C_DIS | C_VEL | C_ORI ;

// ---- expressions

// The order of the alternatives is the precedence, highest first; operators of an alternative
// associate to the left.
//
// Assumed: the comparisons are between the bit operators and the logical operators. What decides
// each case is in docs/reference/krl-language.md#operators. For three BOOLs without parentheses
// (A AND B==C) a controller may differ.
expression
  : operator=('+' | '-' | NOT | B_NOT) expression
  | expression operator=':' expression
  | expression operator=('*' | '/') expression
  | expression operator=('+' | '-') expression
  | expression operator=B_AND expression
  | expression operator=B_EXOR expression
  | expression operator=B_OR expression
  | expression operator=('==' | '<>' | '<' | '<=' | '>' | '>=') expression
  | expression operator=AND expression
  | expression operator=EXOR expression
  | expression operator=OR expression
  | primary
  ;

primary
  : '(' expression ')'
  | INT
  | REAL
  | BITS
  | TRUE
  | FALSE
  | TEXT
  | ENUM_VALUE
  | aggregate
  | reference
  ;

// {X 1,Y 2} or {FRAME: X 1,Y 2}: a colon after the first name makes it a type.
aggregate : '{' (name (':' (field (',' field)*)? | brackets? expression (',' field)*))? '}' ;

field : name brackets? expression ;

reference : name (arguments | steps) ;

variable : name steps ;

steps : brackets? ('.' step)* ;

step : name brackets? ;

brackets : '[' dimension (',' dimension)* ']' ;

dimension : expression? ;

arguments : '(' argument (',' argument)* ')' ;

// (docs/reference/krl-language.md#routines-of-kss)
argument : (expression | ':' name)? ;

// Keywords in one place, names elsewhere.
name
  : NAME
  | CA
  | DELAY
  | DISABLE
  | DISTANCE
  | ENABLE
  | F
  | IN
  | IS
  | MAXIMUM
  | MINIMUM
  | OFF
  | ON
  | ONSTART
  | OUT
  | PART
  | PATH
  | PRIO
  | PUBLIC
  | SEC
  | START
  | STEP
  | WITH
  ;

// ---- tokens

AND : 'AND' ;
B_AND : 'B_AND' ;
B_EXOR : 'B_EXOR' ;
B_NOT : 'B_NOT' ;
B_OR : 'B_OR' ;
BRAKE : 'BRAKE' ;
C_DIS : 'C_DIS' ;
C_ORI : 'C_ORI' ;
C_PTP : 'C_PTP' ;
C_SPL : 'C_SPL' ;
C_VEL : 'C_VEL' ;
CA : 'CA' ;
CASE : 'CASE' ;
CIRC : 'CIRC' ;
CIRC_REL : 'CIRC_REL' ;
CONST : 'CONST' ;
CONTINUE : 'CONTINUE' ;
DECL : 'DECL' ;
DEF : 'DEF' ;
DEFAULT : 'DEFAULT' ;
DEFDAT : 'DEFDAT' ;
DEFFCT : 'DEFFCT' ;
DELAY : 'DELAY' ;
DISABLE : 'DISABLE' ;
DISTANCE : 'DISTANCE' ;
DO : 'DO' ;
ELSE : 'ELSE' ;
ENABLE : 'ENABLE' ;
END : 'END' ;
ENDDAT : 'ENDDAT' ;
ENDFCT : 'ENDFCT' ;
ENDFOR : 'ENDFOR' ;
ENDIF : 'ENDIF' ;
ENDLOOP : 'ENDLOOP' ;
ENDSWITCH : 'ENDSWITCH' ;
ENDWHILE : 'ENDWHILE' ;
ENUM : 'ENUM' ;
EXIT : 'EXIT' ;
EXOR : 'EXOR' ;
EXT : 'EXT' ;
EXTFCT : 'EXTFCT' ;
F : 'F' ;
FALSE : 'FALSE' ;
FOR : 'FOR' ;
GLOBAL : 'GLOBAL' ;
GOTO : 'GOTO' ;
HALT : 'HALT' ;
IF : 'IF' ;
IMPORT : 'IMPORT' ;
IN : 'IN' ;
INTERRUPT : 'INTERRUPT' ;
IS : 'IS' ;
LIN : 'LIN' ;
LIN_REL : 'LIN_REL' ;
LOOP : 'LOOP' ;
MAXIMUM : 'MAXIMUM' ;
MINIMUM : 'MINIMUM' ;
NOT : 'NOT' ;
OFF : 'OFF' ;
ON : 'ON' ;
ONSTART : 'ONSTART' ;
OR : 'OR' ;
OUT : 'OUT' ;
PART : 'PART' ;
PATH : 'PATH' ;
PRIO : 'PRIO' ;
PTP : 'PTP' ;
PTP_REL : 'PTP_REL' ;
PUBLIC : 'PUBLIC' ;
PULSE : 'PULSE' ;
REPEAT : 'REPEAT' ;
RESUME : 'RESUME' ;
RETURN : 'RETURN' ;
SEC : 'SEC' ;
SIGNAL : 'SIGNAL' ;
START : 'START' ;
STEP : 'STEP' ;
STRUC : 'STRUC' ;
SWITCH : 'SWITCH' ;
THEN : 'THEN' ;
TO : 'TO' ;
TRIGGER : 'TRIGGER' ;
TRUE : 'TRUE' ;
UNTIL : 'UNTIL' ;
WAIT : 'WAIT' ;
WHEN : 'WHEN' ;
WHILE : 'WHILE' ;
WITH : 'WITH' ;

ASSIGN : '=' ;
COLON : ':' ;
COMMA : ',' ;
DIVIDE : '/' ;
DOT : '.' ;
DOTS : '..' ;
EQUAL : '==' ;
NOT_EQUAL : '<>' ;
LESS : '<' ;
LESS_OR_EQUAL : '<=' ;
GREATER : '>' ;
GREATER_OR_EQUAL : '>=' ;
MINUS : '-' ;
PLUS : '+' ;
MULTIPLY : '*' ;
LEFT_PARENTHESIS : '(' ;
RIGHT_PARENTHESIS : ')' ;
LEFT_BRACKET : '[' ;
RIGHT_BRACKET : ']' ;
LEFT_BRACE : '{' ;
RIGHT_BRACE : '}' ;

// (docs/reference/krl-values.md#scalars)
INT : DIGIT+ ;
REAL : DIGIT+ EXPONENT | DIGIT+ '.' DIGIT* EXPONENT? | '.' DIGIT+ EXPONENT? ;
BITS : '\'' ('B' [01]+ | 'H' [0-9A-F]+) '\'' ;
TEXT : '"' ~["\r\n]* '"' ;
ENUM_VALUE : '#' WORD ;
NAME : WORD ;
HEADER : '&' ~[\r\n]* ;

COMMENT : ';' ~[\n]* -> channel(HIDDEN) ;
BLANK : [ \t]+ -> channel(HIDDEN) ;
NEWLINE : '\r'* '\n' ;

// Invalid characters are tokens too, so that the parser reports them with their position.
OPEN_TEXT : '"' ~["\r\n]* ;
WRONG_BITS : '\'' ~['\r\n;]* '\''? ;
UNKNOWN : . ;

fragment DIGIT : [0-9] ;
fragment EXPONENT : 'E' [+-]? DIGIT+ ;
fragment WORD : [A-Z_$] [A-Z0-9_$]* ;
