"""The panel of an object: its options, live results, and findings whose rows select faces."""

import json

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from .. import places
from ..library import sentence
from . import icon

DELAY = 300  # ms, between the last change and the recompute
SEVERITY = {"error": (200, 30, 30), "warning": (190, 120, 0), "info": (90, 90, 90)}
FIELDS = {
    "unfold": [("K-factor", "KFactor"), ("Bend table", "KTable"), ("Shop profile", "Shop"), ("Side up", "Up"),
               ("Corners", "Relief"), ("Beside bends", "BendRelief"), ("Holes in forms", "Extruded"), ("Rip edges", "RipEdges")],
    "connect": [("Thickness", "SheetThickness"), ("Inside radius", "InsideRadius"), ("Faces are", "FacesAre"),
                ("Lateral boundaries", "Lateral"), ("K-factor", "KFactor"), ("Bend table", "KTable"), ("Shop profile", "Shop")],
    "transition": [("Thickness", "SheetThickness"), ("Sizes are", "SizesAre"), ("Pieces", "Pieces"),
                   ("Press angle", "PressAngle"), ("Seam at edge", "SeamEdge"), ("K-factor", "KFactor")],
    "bend_plan": [("K-factor", "KFactor"), ("Bend table", "KTable"), ("Shop profile", "Shop"), ("Metal", "Metal"),
                  ("Tools", "Tools")],
}
TITLES = {"unfold": "Unfold", "connect": "Connect plates", "transition": "Transition", "bend_plan": "Bend plan"}
ICONS = {"unfold": "Unfold", "connect": "Connect", "transition": "Transition", "bend_plan": "BendPlan"}


def edit(made, in_transaction=False):
    """Opens the panel of an object of Planish; False if it has none or another panel is open."""
    kind = getattr(getattr(made, "Proxy", None), "planish_kind", "")
    if kind == "drawn":
        return edit(made.Owner, in_transaction)
    if kind not in FIELDS or Gui.Control.activeDialog():
        return False
    Gui.Control.showDialog(Panel(made, in_transaction))
    return True


class Panel:
    """Opened by a double click, or by the command that made the object. Cancel undoes all of it."""

    current = None

    def __init__(self, made, in_transaction=False):
        self.made = made
        self.kind = made.Proxy.planish_kind
        if not in_transaction:
            made.Document.openTransaction(f"Edit {made.Label}")
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(TITLES[self.kind])
        self.form.setWindowIcon(QtGui.QIcon(icon(ICONS[self.kind])))
        self.timer = QtCore.QTimer(self.form)
        self.timer.setSingleShot(True)
        self.timer.setInterval(DELAY)
        self.timer.timeout.connect(self.recompute)
        self.fields = {}
        self._lay_out()
        self.show()
        Panel.current = self

    def _lay_out(self):
        layout = QtGui.QVBoxLayout(self.form)
        options = QtGui.QFormLayout()
        for label, name in FIELDS[self.kind]:
            field = self._field(name)
            self.fields[name] = field
            options.addRow(label, field)
        layout.addLayout(options)
        self.problem = QtGui.QLabel()
        self.problem.setWordWrap(True)
        self.problem.setStyleSheet("color: rgb(200, 30, 30); font-weight: bold")
        layout.addWidget(self.problem)
        self.results = QtGui.QLabel()
        self.results.setWordWrap(True)
        self.results.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        layout.addWidget(self.results)
        self.findings = _table(["", "Finding"])
        self.findings.itemSelectionChanged.connect(self.select)
        layout.addWidget(self.findings, 1)
        if self.kind == "bend_plan":
            self.strokes = _table(["", "Stroke"])
            layout.insertWidget(layout.count() - 1, self.strokes, 2)
        self.write = QtGui.QPushButton("Write plan…" if self.kind == "bend_plan" else "Write DXF…")
        self.write.clicked.connect(self.write_file)
        layout.addWidget(self.write)

    def _field(self, name):
        made = self.made
        kind, value = made.getTypeIdOfProperty(name), getattr(made, name)
        if kind == "App::PropertyEnumeration":
            field = QtGui.QComboBox()
            field.addItems(made.getEnumerationsOfProperty(name))
            field.setCurrentText(value)
            field.currentTextChanged.connect(lambda text: self.change(name, text))
        elif kind == "App::PropertyFile":
            field = FileField(value, lambda path: self.change(name, path))
        elif kind == "App::PropertyString":
            field = QtGui.QLineEdit(value)
            field.editingFinished.connect(lambda: self.change(name, field.text()))
        elif kind == "App::PropertyInteger":
            field = QtGui.QSpinBox()
            field.setRange(-1, 10000)
            field.setValue(value)
            field.valueChanged.connect(lambda number: self.change(name, number))
        else:
            field = QtGui.QDoubleSpinBox()
            field.setDecimals(3)
            k = kind == "App::PropertyFloatConstraint"
            field.setRange(0.0, 1.0 if k else 360.0 if kind == "App::PropertyAngle" else 1e6)
            field.setSingleStep(0.01 if k else 0.5)
            field.setSuffix("" if k else "°" if kind == "App::PropertyAngle" else " mm")
            field.setValue(getattr(value, "Value", value))
            field.valueChanged.connect(lambda number: self.change(name, number))
        field.setToolTip(made.getDocumentationOfProperty(name))
        return field

    def change(self, name, value):
        setattr(self.made, name, value)
        self.timer.start()

    def recompute(self):
        self.timer.stop()
        self.made.Document.recompute()
        self.show()

    def show(self):
        """Brings the panel up to date with its object."""
        made = self.made
        self.problem.setText(made.Problem)
        self.problem.setVisible(bool(made.Problem))
        self.results.setText("" if made.Problem else results(made))
        self.rows = places.rows(made)
        _fill(self.findings, [(row.severity, row.message) for row in self.rows])
        if self.kind == "bend_plan":
            _fill(self.strokes, [(str(number), text.split(". ", 1)[1]) for number, text in enumerate(made.Strokes, 1)])
        self.write.setEnabled(not made.Problem)

    def select(self):
        """Selects the faces that the chosen finding means."""
        chosen = {index.row() for index in self.findings.selectedIndexes()}
        Gui.Selection.clearSelection()
        for number in chosen:
            try:
                names = places.faces(self.made, self.rows[number])
            except Exception as error:
                App.Console.PrintWarning(f"Planish: {sentence(error)}\n")
                names = []
            for name in names:
                Gui.Selection.addSelection(self.made.Source.Document.Name, self.made.Source.Name, name)

    def write_file(self):
        from . import commands

        if self.kind != "bend_plan":
            commands.write(self.made)
            return
        path, _ = QtGui.QFileDialog.getSaveFileName(self.form, "Write the plan", f"{self.made.Label}.pdf", "PDF (*.pdf)")
        if path:
            try:
                self.made.Proxy.current(self.made).write(path)
            except Exception as error:
                commands.say(sentence(error))

    def getStandardButtons(self):
        buttons = QtGui.QDialogButtonBox.Ok | QtGui.QDialogButtonBox.Cancel
        return buttons.value if hasattr(buttons, "value") else int(buttons)  # PySide 6, PySide 2

    def accept(self):
        if self.timer.isActive():
            self.recompute()
        self.made.Document.commitTransaction()
        return self._close()

    def reject(self):
        self.timer.stop()
        document = self.made.Document
        document.abortTransaction()
        self._close()
        document.recompute()
        return True

    def _close(self):
        Panel.current = None
        Gui.Control.closeDialog()
        return True


class FileField(QtGui.QWidget):
    """A path, and a button that asks for one."""

    def __init__(self, value, changed):
        super().__init__()
        layout = QtGui.QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        self.path = QtGui.QLineEdit(value)
        self.path.editingFinished.connect(lambda: changed(self.path.text()))
        button = QtGui.QToolButton()
        button.setText("…")
        button.clicked.connect(lambda: self._ask(changed))
        layout.addWidget(self.path)
        layout.addWidget(button)

    def _ask(self, changed):
        path, _ = QtGui.QFileDialog.getOpenFileName(self, "Choose a file", self.path.text())
        if path:
            self.path.setText(path)
            changed(path)


def results(made):
    """Sizes, as lines of text."""
    report = json.loads(made.Report) if made.Report else {}
    if made.Proxy.planish_kind == "bend_plan":
        plan = report["plan"]
        return (f"{len(plan['strokes'])} strokes, {plan['turn_overs']} turn-overs, {plan['rotations']} rotations, "
                f"{plan['tool_changes']} tool changes")
    lines = []
    pieces = report.get("pieces") or [report]
    for number, one in enumerate(pieces, 1):
        flat = one["flat"]
        size = " × ".join(f"{length:.3f}" for length in flat["size"])
        lines += [(f"Piece {number}: " if len(pieces) > 1 else "") + f"{size} mm, {one['sheet']['thickness']:.3f} mm thick",
                  f"Area {flat['area']:.2f} mm², cutting {flat['perimeter']:.2f} mm",
                  f"{len(flat['bends'])} bends, {flat['openings']} openings"]
    ratio = (report.get("verification") or {}).get("volume_ratio")
    if ratio is not None:
        lines.append(f"Area × thickness is {ratio:.6f} of the solid's volume")
    return "\n".join(lines)


def _table(headers):
    table = QtGui.QTableWidget(0, len(headers))
    table.setHorizontalHeaderLabels(headers)
    table.horizontalHeader().setStretchLastSection(True)
    table.verticalHeader().hide()
    table.verticalHeader().setSectionResizeMode(QtGui.QHeaderView.ResizeToContents)
    table.setSelectionBehavior(QtGui.QAbstractItemView.SelectRows)
    table.setEditTriggers(QtGui.QAbstractItemView.NoEditTriggers)
    table.setWordWrap(True)
    return table


def _fill(table, rows):
    table.blockSignals(True)
    table.setRowCount(len(rows))
    for number, cells in enumerate(rows):
        for column, text in enumerate(cells):
            item = QtGui.QTableWidgetItem(text)
            item.setToolTip(text)
            if cells[0] in SEVERITY:
                item.setForeground(QtGui.QColor(*SEVERITY[cells[0]]))
            table.setItem(number, column, item)
    table.resizeColumnToContents(0)
    table.blockSignals(False)
