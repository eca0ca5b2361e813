// What a page is given. Written by write_types.py out of the records of cranktrain.web; do not edit.

/** A number; null where there is none. */
export type Float = number | null;

/** Numbers row by row, with how many there are along each dimension. */
export interface Numbers {
  readonly values: Float32Array;
  readonly shape: readonly number[];
}

export interface PageCase {
  readonly is: "PageCase";
  readonly machine: ShownMachine;
  readonly tables: readonly (NumbersOfTable)[];
  readonly varied: string;
  readonly language: string;
  readonly languages: readonly (PageLanguage)[];
  readonly words: CaseWords;
}

export interface ShownMachine {
  readonly is: "ShownMachine";
  readonly name: string;
  readonly made_of: string;
  readonly cycle: Float;
  readonly tabs: readonly (PageTab)[];
  readonly trust: PageTrust | null;
  readonly drawing: MachineDrawing;
  readonly members: PageMembers | null;
  readonly pistons: readonly (PagePiston)[];
  readonly throws: readonly (PageThrow)[];
  readonly ghosts: Numbers;
  readonly words: PageWords;
}

export interface PageTab {
  readonly is: "PageTab";
  readonly name: string;
  readonly title: string;
  readonly content: TabContent | null;
}

export interface TabContent {
  readonly is: "TabContent";
  readonly sentence: string;
  readonly answer: WrittenGroup;
  readonly sheets: readonly (PageSheet)[];
  readonly beside: PageTable | null;
  readonly vectors: readonly (VectorsToScale)[];
  readonly course: PageCourse | null;
  readonly has_others: boolean;
  readonly others: PageOthers | null;
  readonly rests_on: string;
}

export interface WrittenGroup {
  readonly is: "WrittenGroup";
  readonly title: string;
  readonly heads: readonly (string)[];
  readonly rows: readonly (WrittenRow)[];
}

export interface WrittenRow {
  readonly is: "WrittenRow";
  readonly name: string;
  readonly cells: readonly (string)[];
  readonly label: string;
  readonly words: string;
  readonly quantities: readonly (string)[];
}

export interface PageSheet {
  readonly is: "PageSheet";
  readonly title: string;
  readonly columns: readonly (readonly (PageCurves | PageMaps | PagePolars | Bars | Stars | PageWear | ShaftShapes | PageTable | PageSection | ConstructionDrawing | PageEvents | EventStrip | Notes | Ruler)[])[];
}

export interface PageCurves {
  readonly is: "PageCurves";
  readonly panels: readonly (Panel)[];
  readonly over: string;
  readonly is_stack: boolean;
  readonly differences: readonly (Panel)[];
}

export interface Panel {
  readonly is: "Panel";
  readonly title: string;
  readonly unit: string;
  readonly across: Numbers;
  readonly curves: readonly (Curve)[];
  readonly symbol: string;
  readonly across_unit: string;
  readonly over: string;
  readonly marks: readonly (Mark)[];
  readonly levels: readonly (PanelLine)[];
  readonly below: readonly (readonly [Float, string])[];
  readonly corner: readonly (string)[];
  readonly limits: readonly [Float, Float] | null;
  readonly reach: readonly [Float, Float] | null;
  readonly hatched: readonly (readonly [Float, Float])[];
  readonly dimension: string;
}

export interface Curve {
  readonly is: "Curve";
  readonly values: Numbers;
  readonly role: "first" | "second" | "other" | "textbook" | "error" | "main" | "side" | "radial" | "resultant" | "formula" | "chamber" | "whole" | "mean" | "each" | "carried" | "card" | "later_card" | "ray" | "half_ray" | "saved";
  readonly letter: string;
  readonly symbol: string;
  readonly name: string;
  readonly across: Numbers | null;
  readonly is_cloud: boolean;
}

export interface Mark {
  readonly is: "Mark";
  readonly across: Float;
  readonly value: Float;
  readonly sort: "ring" | "dot" | "angle" | "change";
  readonly words: string;
  readonly size: Float;
  readonly angle: Float;
}

export interface PanelLine {
  readonly is: "PanelLine";
  readonly at: Float;
  readonly role: "limit" | "natural" | "declared" | "event" | "often";
  readonly symbol: string;
  readonly number: number;
  readonly is_upright: boolean;
}

export interface PageMaps {
  readonly is: "PageMaps";
  readonly maps: readonly (Map)[];
  readonly over: string;
}

export interface Map {
  readonly is: "Map";
  readonly title: string;
  readonly unit: string;
  readonly across: Numbers;
  readonly up: Numbers;
  readonly values: Numbers;
  readonly up_unit: string;
  readonly upward: string;
  readonly marks: readonly (Mark)[];
}

export interface PagePolars {
  readonly is: "PagePolars";
  readonly diagrams: readonly (PolarDiagram)[];
  readonly unit: string;
  readonly notes: string;
  readonly zoom: string;
}

export interface PolarDiagram {
  readonly is: "PolarDiagram";
  readonly title: string;
  readonly curves: readonly (PolarCurve)[];
  readonly largest: Numbers;
  readonly largest_at: Float;
  readonly cycle: Float;
  readonly marked: Numbers;
  readonly marks: Numbers;
}

export interface PolarCurve {
  readonly is: "PolarCurve";
  readonly points: Numbers;
  readonly place: number | null;
}

export interface Bars {
  readonly is: "Bars";
  readonly title: string;
  readonly unit: string;
  readonly low: Numbers;
  readonly high: Numbers;
  readonly is_filled: readonly boolean[];
  readonly across: Numbers;
  readonly names: readonly (string)[];
  readonly framed: number;
  readonly notes: readonly (string)[];
}

export interface Stars {
  readonly is: "Stars";
  readonly title: string;
  readonly rays: readonly (Rays)[];
}

export interface Rays {
  readonly is: "Rays";
  readonly title: string;
  readonly direction: Numbers;
  readonly size: Numbers;
  readonly names: readonly (string)[];
  readonly hole: Float;
  readonly hole_angle: Float;
}

export interface PageWear {
  readonly is: "PageWear";
  readonly rows: readonly (readonly (Rays)[])[];
  readonly most: Float;
  readonly words: string;
}

export interface ShaftShapes {
  readonly is: "ShaftShapes";
  readonly title: string;
  readonly shapes: readonly (ShaftShape)[];
  readonly names: readonly (string)[];
}

export interface ShaftShape {
  readonly is: "ShaftShape";
  readonly title: string;
  readonly amplitude: Numbers;
  readonly following: readonly number[];
  readonly nodes: Numbers;
}

export interface PageTable {
  readonly is: "PageTable";
  readonly title: string;
  readonly heads: readonly (string)[];
  readonly groups: readonly (string)[];
  readonly rows: readonly (readonly (string)[])[];
  readonly methods: readonly (number)[];
  readonly notes: readonly (string)[];
  readonly of_words: readonly (number)[];
}

export interface PageSection {
  readonly is: "PageSection";
  readonly heading: string;
  readonly parts: readonly (PageTable | Notes)[];
}

export interface Notes {
  readonly is: "Notes";
  readonly sentences: readonly (string)[];
  readonly can_go_on: boolean;
}

export interface ConstructionDrawing {
  readonly is: "ConstructionDrawing";
  readonly title: string;
  readonly radius: Float;
  readonly along: Numbers;
  readonly foot: Numbers;
  readonly points: Readonly<Record<string, Numbers>>;
  readonly lines: readonly (ConstructedLine)[];
  readonly readings: readonly (ConstructionReading)[];
  readonly unit: string;
  readonly note: string;
}

export interface ConstructedLine {
  readonly is: "ConstructedLine";
  readonly start: string;
  readonly end: string;
  readonly look: "link" | "exact" | "projection" | "ray";
  readonly about: string;
}

export interface ConstructionReading {
  readonly is: "ConstructionReading";
  readonly point: string;
  readonly name: string;
  readonly look: "exact" | "projection" | "ray";
  readonly displacement: Numbers;
}

export interface PageEvents {
  readonly is: "PageEvents";
  readonly title: string;
  readonly events: readonly (PageEvent)[];
}

export interface PageEvent {
  readonly is: "PageEvent";
  readonly at: Float;
  readonly number: number;
  readonly time: string;
  readonly name: string;
  readonly angle: string;
  readonly speed: string;
}

export interface EventStrip {
  readonly is: "EventStrip";
  readonly events: readonly (PageEvent)[];
  readonly end: Float;
}

export interface Ruler {
  readonly is: "Ruler";
  readonly heading: string;
  readonly marks: readonly (RulerMark)[];
  readonly pistons: readonly (string)[];
  readonly textbook: string;
  readonly is_of_cylinders: boolean;
}

export interface RulerMark {
  readonly is: "RulerMark";
  readonly name: string;
  readonly angle: Float;
  readonly is_top: boolean;
  readonly word: string;
}

export interface VectorsToScale {
  readonly is: "VectorsToScale";
  readonly title: string;
  readonly unit: string;
  readonly largest: Float;
  readonly vectors: readonly (PinVector)[];
}

export interface PinVector {
  readonly is: "PinVector";
  readonly mechanism: string;
  readonly pin: string;
  readonly letter: string;
  readonly symbol: string;
  readonly value: Numbers;
}

export interface PageCourse {
  readonly is: "PageCourse";
  readonly unit: string;
  readonly time: Numbers;
  readonly crank_angle: Numbers;
  readonly step: Float;
  readonly paces: readonly (PagePace)[];
  readonly at_first: number;
  readonly words: CourseWords;
}

export interface PagePace {
  readonly is: "PagePace";
  readonly rate: Float;
  readonly words: string;
}

export interface CourseWords {
  readonly is: "CourseWords";
  readonly drawing: string;
  readonly time: string;
  readonly play: string;
  readonly stop: string;
  readonly back: string;
  readonly on: string;
  readonly keys: string;
  readonly pace: string;
}

export interface PageOthers {
  readonly is: "PageOthers";
  readonly parts: readonly (readonly (readonly (OtherCurve)[])[])[];
}

export interface OtherCurve {
  readonly is: "OtherCurve";
  readonly names: readonly (string)[];
  readonly symbol: string;
  readonly values: Numbers;
  readonly across: Numbers | null;
}

export interface PageTrust {
  readonly is: "PageTrust";
  readonly to_mind: readonly (string)[];
  readonly checks: readonly (PageCheck)[];
}

export interface PageCheck {
  readonly is: "PageCheck";
  readonly sentence: string;
  readonly verdict: string;
  readonly holds: boolean | null;
}

export interface MachineDrawing {
  readonly is: "MachineDrawing";
  readonly name: string;
  readonly crank_angle: Numbers;
  readonly shafts: readonly (ShaftDrawing)[];
  readonly mechanisms: readonly (MechanismDrawing)[];
  readonly left_out: readonly (string)[];
  readonly loads: readonly (LoadDrawing)[];
  readonly bounds: Numbers;
  readonly unit: string;
  readonly one: Float;
}

export interface ShaftDrawing {
  readonly is: "ShaftDrawing";
  readonly name: string;
  readonly centre: Numbers;
  readonly is_assumed: boolean;
  readonly sense: Float;
}

export interface MechanismDrawing {
  readonly is: "MechanismDrawing";
  readonly name: string;
  readonly kind: string;
  readonly cylinder: string;
  readonly bank: string;
  readonly shaft: string;
  readonly throw: number;
  readonly is_slave: boolean;
  readonly is_outlined: boolean;
  readonly crank_zero: Float;
  readonly pins: Readonly<Record<string, Numbers>>;
  readonly links: readonly (LinkDrawing)[];
  readonly guides: readonly (GuideDrawing)[];
  readonly blocks: readonly (Block)[];
  readonly fixed: readonly (string)[];
  readonly ends: readonly (string)[];
  readonly points: readonly (string)[];
  readonly paths: Readonly<Record<string, Numbers>>;
  readonly output: OutputDrawing | null;
}

export interface LinkDrawing {
  readonly is: "LinkDrawing";
  readonly name: string;
  readonly pins: readonly (string)[];
  readonly is_crank: boolean;
}

export interface GuideDrawing {
  readonly is: "GuideDrawing";
  readonly pin: string;
  readonly direction: Float;
  readonly foot: Numbers;
}

export interface Block {
  readonly is: "Block";
  readonly pin: string;
  readonly link: readonly (string)[];
}

export interface OutputDrawing {
  readonly is: "OutputDrawing";
  readonly pin: string;
  readonly foot: Numbers;
  readonly along: Numbers;
  readonly travel: Numbers;
  readonly bore: Float | null;
  readonly is_valve: boolean;
  readonly is_far: boolean;
  readonly port: Float | null;
  readonly crosshead: CrossheadDrawing | null;
  readonly ram: RamDrawing | null;
}

export interface CrossheadDrawing {
  readonly is: "CrossheadDrawing";
  readonly rod_length: Float;
  readonly rod_diameter: Float;
  readonly piston: Float;
  readonly shoe: Numbers;
  readonly bars: Numbers;
  readonly gland: Float;
  readonly covers: Numbers;
}

export interface RamDrawing {
  readonly is: "RamDrawing";
  readonly width: Float;
  readonly face: Float;
  readonly back: Float;
  readonly ends: Numbers;
  readonly bed: Float;
}

export interface LoadDrawing {
  readonly is: "LoadDrawing";
  readonly name: string;
  readonly mechanism: string;
  readonly link: string;
  readonly is_torque: boolean;
  readonly is_rope: boolean;
  readonly size: Numbers;
  readonly largest: Float;
  readonly unit: string;
  readonly one: Float;
  readonly way: Numbers;
  readonly place: Numbers;
  readonly pin: Numbers;
}

export interface PageMembers {
  readonly is: "PageMembers";
  readonly tables: readonly (CursorTable)[];
  readonly note: string;
}

export interface CursorTable {
  readonly is: "CursorTable";
  readonly head: string;
  readonly names: readonly (string)[];
  readonly columns: readonly (CursorColumn)[];
  readonly values: Numbers;
}

export interface CursorColumn {
  readonly is: "CursorColumn";
  readonly head: string;
  readonly step: Float;
  readonly n_parts: number;
  readonly around: Float | null;
}

export interface PagePiston {
  readonly is: "PagePiston";
  readonly name: string;
  readonly number: string;
  readonly firing: string;
  readonly shaft: string;
  readonly throw: number;
}

export interface PageThrow {
  readonly is: "PageThrow";
  readonly shaft: string;
  readonly number: number;
  readonly direction: Float;
}

export interface PageWords {
  readonly is: "PageWords";
  readonly drawing: string;
  readonly angle: string;
  readonly play: string;
  readonly stop: string;
  readonly back: string;
  readonly on: string;
  readonly keys: string;
  readonly checks: string;
  readonly numbers: string;
  readonly left_out: string;
  readonly differences: string;
  readonly vectors: string;
  readonly colours: string;
  readonly colours_of_system: string;
  readonly light: string;
  readonly dark: string;
  readonly ghosts: string;
  readonly pistons: string;
  readonly others: string;
  readonly others_hint: string;
  readonly throws: string;
  readonly members: string;
}

export interface NumbersOfTable {
  readonly is: "NumbersOfTable";
  readonly name: string;
  readonly inputs: readonly (PageInput)[];
}

export interface PageInput {
  readonly is: "PageInput";
  readonly path: string;
  readonly name: string;
  readonly text: string;
  readonly status: string;
  readonly note: string;
}

export interface PageLanguage {
  readonly is: "PageLanguage";
  readonly code: string;
  readonly name: string;
}

export interface CaseWords {
  readonly is: "CaseWords";
  readonly machine: string;
  readonly numbers: string;
  readonly undo: string;
  readonly redo: string;
  readonly save: string;
  readonly as_in_file: string;
  readonly compare: string;
  readonly keep: string;
  readonly gallery: string;
  readonly open: string;
  readonly export: string;
  readonly more: string;
  readonly unnamed: string;
  readonly second: string;
  readonly whence: string;
  readonly stages: string;
  readonly rests_on: string;
  readonly close: string;
  readonly design: DesignWords;
  readonly move: string;
  readonly adding: AddingWords;
  readonly others: string;
  readonly language: string;
  readonly no_answer: string;
}

export interface DesignWords {
  readonly is: "DesignWords";
  readonly title: string;
  readonly varied: string;
  readonly second: string;
  readonly nothing: string;
  readonly start: string;
  readonly end: string;
  readonly count: string;
  readonly wanted: string;
  readonly compute: string;
  readonly cancel: string;
  readonly hint: string;
  readonly numbers: string;
}

export interface AddingWords {
  readonly is: "AddingWords";
  readonly add: string;
  readonly back: string;
  readonly cancel: string;
  readonly cross: string;
}

export interface PageHandles {
  readonly is: "PageHandles";
  readonly handles: readonly (DrawnHandle)[];
  readonly additions: readonly (DrawnAddition)[];
  readonly open: readonly (string)[];
}

export interface DrawnHandle {
  readonly is: "DrawnHandle";
  readonly mechanism: string;
  readonly pin: string;
  readonly numbers: readonly (HandledNumber)[];
  readonly at: Numbers | null;
  readonly slides: string;
}

export interface HandledNumber {
  readonly is: "HandledNumber";
  readonly paths: readonly (string)[];
  readonly number: Float;
  readonly unit: string;
  readonly step: Float;
  readonly slope: Numbers;
}

export interface DrawnAddition {
  readonly is: "DrawnAddition";
  readonly mechanism: string;
  readonly name: string;
  readonly title: string;
  readonly clicks: readonly (DrawnClick)[];
}

export interface DrawnClick {
  readonly is: "DrawnClick";
  readonly asks: string;
  readonly targets: readonly (DrawnTarget)[];
  readonly begins: boolean;
}

export interface DrawnTarget {
  readonly is: "DrawnTarget";
  readonly name: string;
  readonly words: string;
  readonly pins: readonly (string)[];
  readonly then: number;
}

export interface PageGoingOn {
  readonly is: "PageGoingOn";
  readonly trust: PageTrust;
  readonly offers: readonly (PageOffer)[];
  readonly facts: readonly (OfferedFact)[];
  readonly exports: readonly (ExportForm)[];
}

export interface PageOffer {
  readonly is: "PageOffer";
  readonly key: string;
  readonly words: string;
}

export interface OfferedFact {
  readonly is: "OfferedFact";
  readonly name: string;
  readonly title: string;
}

export interface ExportForm {
  readonly is: "ExportForm";
  readonly suffix: string;
  readonly words: string;
}

export interface Gallery {
  readonly is: "Gallery";
  readonly examples: readonly (GalleryItem)[];
  readonly kinds: readonly (GalleryItem)[];
  readonly words: GalleryWords;
}

export interface GalleryItem {
  readonly is: "GalleryItem";
  readonly name: string;
  readonly title: string;
  readonly kind: string;
  readonly made_of: string;
  readonly text: string;
  readonly drawing: MachineDrawing;
}

export interface GalleryWords {
  readonly is: "GalleryWords";
  readonly examples: string;
  readonly kinds: string;
  readonly search: string;
  readonly open: string;
  readonly close: string;
  readonly none: string;
}

export interface SweptDesignsOfPage {
  readonly is: "SweptDesignsOfPage";
  readonly varied: readonly (SweptValues)[];
  readonly facts: readonly (SweptFact)[];
  readonly sheet: PageSheet;
  readonly minded: readonly (string)[];
}

export interface SweptValues {
  readonly is: "SweptValues";
  readonly path: string;
  readonly name: string;
  readonly texts: readonly (string)[];
  readonly numbers: Numbers | null;
  readonly unit: string;
}

export interface SweptFact {
  readonly is: "SweptFact";
  readonly name: string;
  readonly title: string;
  readonly of: string;
  readonly unit: string;
  readonly values: Numbers;
}

export interface PageWhence {
  readonly is: "PageWhence";
  readonly title: string;
  readonly sentences: readonly (string)[];
  readonly stages: readonly (string)[];
  readonly inputs: readonly (string)[];
}
