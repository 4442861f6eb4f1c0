/** The page of a kind of problem. Texts are single-line Markdown. */
export interface ProblemText {
  status: number;
  title: string;
  /** effect on the request */
  what: string;
  /** usual causes */
  why: string;
  /** solutions, most likely first */
  fix: readonly string[];
}
