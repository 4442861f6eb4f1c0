export { CompiledProgram } from "./compiled-program.ts";
export {
  parseProgram,
  readProgram,
  type Condition,
  type ProgramDocument,
  type Rule,
} from "./program-document.ts";
export {
  conditionKinds,
  DEFAULT_ACTION,
  DEFAULT_NUMBER,
  MAX_PLUS,
  MAX_RULES,
  MAX_THAN,
  menuActions,
  type Comparator,
  type ConditionKind,
} from "./vocabulary.ts";
