export { CompiledConditions } from "./compiled-conditions.ts";
export {
  codeFiles,
  codeLanguages,
  programCode,
  type CodeLanguage,
  type ProgramCode,
} from "./code-export/code-file.ts";
export { scriptLines, type ScriptLine, type ScriptLines } from "./code-export/script-lines.ts";
export { countLines } from "./count-lines.ts";
export { conditionOf, kindOf, numberOf, numberRange } from "./condition-parts.ts";
export { emptyProgram } from "./empty-program.ts";
export { evaluateCondition, type EvaluatedCondition } from "./evaluate-condition.ts";
export { programPresets, type ProgramPreset, type ProgramPresetId } from "./presets.ts";
export { CompiledProgram } from "./compiled-program.ts";
export { isSameBehaviour, isSameProgram, isSameRule } from "./same-program.ts";
export {
  parseProgram,
  programSchema,
  readProgram,
  type Condition,
  type ProgramDocument,
  type Rule,
} from "./program-document.ts";
export {
  addRule,
  moveRule,
  removeRule,
  rename,
  setAction,
  setCondition,
  setDefault,
  setNumber,
  type ProgramEdit,
  type ProgramRefusal,
} from "./program-edit.ts";
export {
  conditionKinds,
  DEFAULT_ACTION,
  DEFAULT_NUMBER,
  MAX_NAME_LENGTH,
  MAX_RULES,
  menuActions,
  paperActions,
  type Comparator,
  type ConditionKind,
} from "./vocabulary.ts";
