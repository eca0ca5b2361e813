"""Sources: citation keys, `[key]` in a docstring, a plot or a report stands for one; and pages of our own theory."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Reference:
    """A source and the key by which it is cited; the text is in the source's own language, as far as it is known."""

    key: str
    text: str


REFERENCES: dict[str, Reference] = {
    reference.key: reference
    for reference in (
        Reference(
            "steam-engine",
            "«Кривошипно-шатунный механизм», § 10 «Кинематическое исследование кривошипно-шатунного механизма», "
            "формулы (333)–(337), фиг. 146, 147 (о паровой машине; автор в тексте не назван)",
        ),
        Reference(
            "gandzha",
            "Ганджа Л. И. О статическом и маховом моментах привода шатунно-кривошипных механизмов, формулы (1)–(21)",
        ),
        Reference(
            "slider-crank-synthesis",
            "Без названия: синтез кривошипно-ползунного механизма по ходу ползуна и допустимому углу давления "
            "(автор в тексте не назван)",
        ),
        Reference(
            "bolotin",
            "Болотин Ф. Ф. Динамика корабельных ДВС: учебное пособие, §§ 2–3 (противоположно движущиеся поршни, "
            "прицепной шатун), формулы (I.11)–(I.13)",
        ),
        Reference(
            "crankshaft-reactions",
            "Без названия: реакции опор коленчатого вала, формулы (44)–(53), рис. 35 (автор в тексте не назван)",
        ),
        Reference("brix-1893", "Брикс Ф. А. «Морской сборник», № 5, 1893"),
        Reference("kunitsky-1938", "Куницкий Н. П. Электрооборудование прокатных и термических цехов, 1938"),
        Reference("popov-1945", "Попов В. К. Основы электропривода, 1945"),
        Reference("kolchin-demidov", "Kolchin and Demidov, chapter on engine dynamics"),
        Reference("khurmi-gupta", "Khurmi and Gupta, Theory of Machines, chapters 15 and 16"),
        Reference("bevan", "Bevan, The Theory of Machines, chapters 12, 14 and 15"),
        Reference("sarkar", "Sarkar, Theory of Machines, chapters 5 and 11"),
        Reference("machinerys-handbook", "Machinery's Handbook, Flywheels: safe speed of cast-iron rims, 100 ft/s"),
        Reference("cowper-1966", "Cowper, The shear coefficient in Timoshenko's beam theory, J. Appl. Mech. 33, 1966"),
        Reference(
            "carter-1928", "Carter, An empirical formula for crank-shaft stiffness in torsion, Engineering, 1928"
        ),
        Reference("ker-wilson", "Ker Wilson, Practical solution of torsional vibration problems, volume 1"),
        Reference("zimanenko", "Зиманенко, формула приведённой длины колена (по пересказам; печатного источника нет)"),
        Reference("api-11e", "API Spec 11E (pumping units)"),
    )
}
"""Every reference by its key."""

CONVENTIONS = "docs/conventions"
THEORY_OF_BALANCE = "docs/theory/balance"
THEORY_OF_CLUTCHED_DRIVES = "docs/theory/clutched-drive"
THEORY_OF_CRANKSHAFT = "docs/theory/crankshaft"
THEORY_OF_CRANK_ROCKERS = "docs/theory/crank-rocker"
THEORY_OF_DRIVES = "docs/theory/drive"
THEORY_OF_EVENNESS = "docs/theory/evenness"
THEORY_OF_FORCES = "docs/theory/forces"
THEORY_OF_GAS = "docs/theory/gas"
THEORY_OF_GROUPS = "docs/theory/groups"
THEORY_OF_HARMONICS = "docs/theory/harmonics-and-orders"
THEORY_OF_OPPOSED_PISTONS = "docs/theory/opposed-pistons"
THEORY_OF_PUMPING_UNITS = "docs/theory/pumping-unit"
THEORY_OF_SLIDER_CRANKS = "docs/theory/slider-crank"
THEORY_OF_TORSION = "docs/theory/torsion"
THEORY_OF_TRANSIENTS = "docs/theory/transient"
"""Pages on which several results stand."""
