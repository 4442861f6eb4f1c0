/** A section of `npm run bench:page`: measures the built page, prints tables and returns goals. */
import type { Browser } from "playwright";
import type { Goal } from "../core/goals.ts";

export interface PageUnderTest {
  browser: Browser;
  /** URL of the built page at the relay, without a trailing slash */
  url: string;
}

export interface Section {
  title: string;
  measure: (page: PageUnderTest) => Promise<readonly Goal[]>;
}
