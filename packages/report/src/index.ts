export { csvLines, type CsvValue } from "./csv.ts";
export {
  reportOf,
  type Mean,
  type QuestionReport,
  type Report,
  type StudentShare,
  type TaskReport,
} from "./report.ts";
export { joinStudies, readStudyCsv, studyCsv } from "./study-csv.ts";
export { MAX_LABEL, type Answers, type Study, type Work } from "./study.ts";
