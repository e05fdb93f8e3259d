# FreeCAD runs this at every start, with or without a window. Documents find their objects' classes by themselves.
