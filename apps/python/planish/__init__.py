"""Sheet metal laid flat, and shown to be right.

    import planish
    part = planish.unfold("part.step", k=0.44)
    print(part.flat.area, len(part.flat.bends))
    part.write("part.dxf")

Lengths are mm, or what `units` says. Reports and options are those of the program: docs/formats.md, docs/python.md.
"""

from ._errors import Cancelled, Error, Failed, InvalidInput, Refused
from . import _makers
from ._makers import *
from ._parts import Bend, BendPlan, Flat, Mesh, Part
from ._planish import schema_names, version as __version__
from ._program import batch, info, pack, schema
from ._record import Record

__all__ = ["Bend", "BendPlan", "Cancelled", "Error", "Failed", "Flat", "InvalidInput", "Mesh", "Part", "Record",
           "Refused", "__version__", "batch", "info", "pack", "schema", "schema_names"]
__all__ += _makers.__all__
