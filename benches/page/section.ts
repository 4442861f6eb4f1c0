/** A part of `npm run bench:page`: measures something of the built page, prints what it saw, and judges it. */
import type { Browser } from "playwright";
import type { Goal } from "../core/goals.ts";

export interface PageUnderTest {
  browser: Browser;
  /** address of the built page as the relay serves it, without a slash at its end */
  url: string;
}

export interface Section {
  title: string;
  measure: (page: PageUnderTest) => Promise<readonly Goal[]>;
}
