// Writes generated/NAME.ts for each ../docs/schema/NAME.json: a type for every object of the schema, named by
// where it is found ("bends" of "flat" of a report: ReportFlatBend). Objects of a file that are the same have one name.
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';

const schemas = new URL('../../docs/schema/', import.meta.url),
  out = new URL('../generated/', import.meta.url);
const plain = { string: 'string', integer: 'number', number: 'number', boolean: 'boolean', null: 'null' };
const longestTuple = 4;

const capital = (key) => key.replace(/(?:^|[_\W])(\w)/g, (_, letter) => letter.toUpperCase());
const singular = (key) =>
  key
    .replace(/(\w\w)ies$/, '$1y')
    .replace(/(ch)es$/, '$1')
    .replace(/(\w[^su])s$/, '$1');
const unique = (types) => [...new Set(types)];
const inList = (type) => (type.includes(' | ') ? `(${type})` : type);

const formsOf = (schema) => (schema.if ? [...formsOf(schema.then), ...formsOf(schema.else)] : [schema]);

class Module {
  named = new Map(); // the text of each type, by its name

  /** The type that a schema describes; what needs a name of its own gets `name`. */
  of(schema, name) {
    if (schema.anyOf) return unique(schema.anyOf.map((one) => this.of(one, name))).join(' | ');
    if (schema.enum) return schema.enum.map((word) => (typeof word === 'string' ? `'${word}'` : word)).join(' | ');
    if (schema.if) return this.either(schema, name);
    if (Array.isArray(schema.type))
      return unique(schema.type.map((type) => this.of({ ...schema, type }, name))).join(' | ');
    if (schema.type === 'array') return this.list(schema, name);
    if (schema.type === 'object') return this.object(schema, name);
    return plain[schema.type] ?? 'unknown';
  }

  list({ items = {}, minItems, maxItems }, name) {
    const type = this.of(items, name);
    if (minItems === maxItems && minItems <= longestTuple) return `[${Array(minItems).fill(type).join(', ')}]`;
    return `${inList(type)}[]`;
  }

  object({ properties, additionalProperties: more = true, minProperties, maxProperties, required }, name) {
    if (!properties) return `Record<string, ${more === true ? 'unknown' : this.of(more, singular(name))}>`;
    const isOneKey = minProperties === 1 && maxProperties === 1,
      forms = isOneKey ? Object.keys(properties).map((key) => [key]) : [Object.keys(properties)];
    const text = (keys) =>
      this.fields({ properties, additionalProperties: more, required: isOneKey ? keys : required }, keys, name);
    return this.add(name, forms.map(text).join(' | '));
  }

  /** Of several forms, told apart by the keys of one; each may be asked for what only another has. */
  either(schema, name) {
    const forms = formsOf(schema),
      keys = [...new Set(forms.flatMap(({ properties }) => Object.keys(properties)))];
    return this.add(name, forms.map((form) => this.fields(form, keys, name)).join(' | '));
  }

  fields({ properties, additionalProperties: more = true, required = [] }, keys, name) {
    const fields = keys.map((key) => {
      const schema = properties[key];
      if (!schema) return `  ${key}?: undefined;\n`;
      const type = this.of(schema, name + capital(schema.type === 'array' ? singular(key) : key)),
        said = schema.description ? `  /** ${schema.description} */\n` : '';
      return `${said}  ${key}${required.includes(key) ? '' : '?'}: ${type};\n`;
    });
    return `{\n${fields.join('')}${more ? '  [key: string]: unknown;\n' : ''}}`;
  }

  /** The name of a type: another one if it is there already. */
  add(name, text) {
    const same = [...this.named].find(([, known]) => known === text);
    if (!same && this.named.has(name)) throw new Error(`two types would be called ${name}`);
    if (!same) this.named.set(name, text);
    return same?.[0] ?? name;
  }

  text(file) {
    const types = [...this.named].map(([name, text]) => `export type ${name} = ${text};\n`);
    return `// Written by tools/write-types.mjs from docs/schema/${file}.\n\n${types.join('\n')}`;
  }
}

mkdirSync(out, { recursive: true });
for (const file of readdirSync(schemas).filter((name) => name.endsWith('.json'))) {
  const name = file.replace(/\.json$/, ''),
    module = new Module();
  module.of(JSON.parse(readFileSync(new URL(file, schemas), 'utf8')), capital(name));
  const path = new URL(`${name}.ts`, out),
    text = module.text(file);
  // What is the same stays as old as it is: the page is built again when its files change.
  if (read(path) !== text) writeFileSync(path, text);
}

function read(path) {
  try {
    return readFileSync(path, 'utf8');
  } catch {
    return null;
  }
}
