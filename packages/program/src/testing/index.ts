export { arbitraryCondition, arbitraryProgram } from "./arbitrary-program.ts";
export { paperPrograms, type PaperOutcome, type PaperProgram } from "./paper-programs.ts";
