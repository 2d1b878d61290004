# Prints the program in the comment at the head of event.h.
/^ \*   #include "hull.h"/ { inside = 1 }
inside && /^ \*(   .*)?$/ { print substr($0, 6); next }
inside { exit }
