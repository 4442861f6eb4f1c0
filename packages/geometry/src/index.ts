export { normaliseHeading, writeUnitVector } from "./heading.ts";
