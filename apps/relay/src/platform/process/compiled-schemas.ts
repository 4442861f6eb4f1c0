/**
 * Enables zod's compiled schemas, because the relay validates tens of thousands of messages a
 * second. The content security policy of pages forbids them. Import this before any module that
 * creates a schema.
 */
import { z } from "zod";

z.config({ jitless: false });
