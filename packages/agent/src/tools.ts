/** All tools, in the order in which agents see them. */
import type { Tool as ListedTool } from "@modelcontextprotocol/server";
import { z } from "zod";
import { actTool, resetTool, stopTool } from "./commands.ts";
import { lookTool } from "./look.ts";
import { senseTool } from "./sense.ts";
import type { Tool } from "./tool.ts";
import { waitTool } from "./wait.ts";

export const tools: readonly Tool[] = [senseTool, lookTool, waitTool, actTool, stopTool, resetTool];

const descriptions = tools.map(describe);

/** The tools as clients receive them. @param mayDrive whether the key may drive */
export function listedTools(mayDrive: boolean): ListedTool[] {
  return descriptions.filter((_, index) => mayDrive || tools[index]?.drives === false);
}

function describe({ name, description, input, output, drives }: Tool): ListedTool {
  return {
    name,
    description,
    inputSchema: schemaOf(input),
    outputSchema: schemaOf(output),
    annotations: { readOnlyHint: !drives, destructiveHint: false, openWorldHint: false },
  };
}

function schemaOf(schema: z.ZodType): { type: "object" } {
  // The output of conditions is described; their input is unknown until it is read.
  const { $schema: _, ...rest } = z.toJSONSchema(schema, { io: "output" });
  return { ...rest, type: "object" };
}
