/**
 * The relay checks tens of thousands of messages a second, so zod may compile its schemas here. Pages may not:
 * their content security policy forbids it. Imported before anything that makes a schema.
 */
import { z } from "zod";

z.config({ jitless: false });
