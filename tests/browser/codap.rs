//! The page as a data plugin of CODAP: a host that answers as CODAP does, and what it is told.

use crate::engines::Graphics;
use crate::page::Page;
use crate::sameness::native;
use serde_json::{Value, json};

/// A host with the other end of CODAP's line: it says hello when it is called, calls once itself, and keeps tables.
const HOST: &str = "
    <!doctype html><link rel=icon href=data:><body style='margin:0'>
    <iframe src='ADDRESS' width=900 height=640></iframe>
    <script>
      requests = []; answers = []; tables = {}; items = {}; shown = []; kept = KEPT
      const post = content => frames[0].postMessage({type: 'data-interactive', content}, '*')
      const reply = ({action, resource, values}) => {
        const table = (resource.match(/^dataContext\\[([^\\]]+)\\]/) || [])[1]
        if (action === 'update' && resource === 'interactiveFrame') return {success: true}
        if (action === 'get' && resource === 'interactiveFrame') return {success: true, values: {savedState: kept}}
        if (action === 'get' && table) return table in tables ? {success: true, values: tables[table]}
          : {success: false, values: {error: 'Unable to find data context ' + table}}
        if (action === 'create' && resource === 'dataContext') {
          tables[values.name] = values; items[values.name] = []
          return {success: true, values: {name: values.name}}
        }
        if (action === 'create' && resource.endsWith('.item') && table in tables) {
          items[table].push(...values)
          return {success: true}
        }
        if (action === 'create' && resource === 'component') { shown.push(values); return {success: true} }
        return {success: false, values: {error: 'Unknown request'}}
      }
      addEventListener('message', ({data}) => {
        if (data.type === 'hello') {
          frames[0].postMessage({type: 'hello', origin: location.origin}, '*')
        } else if (data.type === 'data-interactive' && data.content.messageType === 'call') {
          const {uuid, value} = data.content
          requests.push(value.action + ' ' + value.resource)
          post({messageType: 'returnValue', uuid, value: reply(value)})
        } else if (data.type === 'data-interactive' && data.content.messageType === 'returnValue') {
          answers.push([data.content.uuid, data.content.value])
        }
      })
      ask = (uuid, value) => post({messageType: 'call', uuid, value})
    </script>";

const DAYS: &str = "clonal_mosaic_days";

fn open(page: &Page, link: &str, kept: Value) {
    let address = format!("{}#{link}", page.server.address());
    page.go_to_host(&HOST.replace("ADDRESS", &address).replace("KEPT", &kept.to_string()));
}

/// Presses a button of the bar in the frame, when it says that the line is open.
fn press(page: &Page, button: &str) {
    page.in_frame(|| {
        page.ready();
        page.wait_for(
            "the line",
            "const told = document.querySelector('#codap .told');
             return !!told && /Connected|are in CODAP/.test(told.textContent)",
        );
        page.run(&format!("document.querySelector('#codap {button}').click()"));
    });
}

fn wait_for_items(page: &Page, table: &str, count: usize) -> Vec<Value> {
    let begun = std::time::Instant::now();
    loop {
        let items = page.run(&format!("return items['{table}'] || []"));
        let items = items.as_array().cloned().unwrap_or_default();
        if items.len() >= count {
            assert_eq!(items.len(), count);
            return items;
        }
        let requests = page.run("return requests");
        assert!(begun.elapsed().as_secs() < 60, "{requests}: {items:?}");
        std::thread::sleep(std::time::Duration::from_millis(50));
    }
}

#[test]
fn days_and_individuals_become_cases_of_tables() {
    let Some(page) = Page::start(Graphics::Neither) else { return };
    open(&page, "mushroom?v=1&s=2&d=2&days=3~codap", Value::Null);
    press(&page, ".this");
    let items = wait_for_items(&page, DAYS, 1);
    let day = &items[0];
    assert_eq!(
        [&day["plant"], &day["individual"], &day["day"]],
        [&json!("Fly agaric"), &json!(2), &json!(2)]
    );
    assert_eq!(day["fingerprint"], native("mushroom?v=1&s=2&d=2&days=3"));
    let link = day["link"].as_str().unwrap();
    assert_eq!(link, format!("{}#mushroom?v=1&s=2&d=2&days=3", page.server.address()));
    assert!(day["patches_F"].as_u64() > Some(0) && day["share_F"].as_f64() < Some(1.0), "{day}");
    assert_eq!(
        page.run("return requests"),
        json!([
            "update interactiveFrame",
            "get interactiveFrame",
            format!("get dataContext[{DAYS}]"),
            "create dataContext",
            "create component",
            format!("create dataContext[{DAYS}].item")
        ])
    );
    assert_eq!(page.run("return shown"), json!([{"type": "caseTable", "dataContext": DAYS}]));
    // All columns of the table are filled, and nothing else is sent.
    let unlike = "const columns = tables['clonal_mosaic_days'].collections.flatMap(c => c.attrs.map(a => a.name));
                  const sent = Object.keys(items['clonal_mosaic_days'][0]);
                  return columns.filter(c => !sent.includes(c)).concat(sent.filter(c => !columns.includes(c)))";
    assert_eq!(page.run(unlike), json!([]));

    // The other days, and none twice.
    press(&page, ".all");
    let mut days: Vec<u64> =
        wait_for_items(&page, DAYS, 4).iter().filter_map(|day| day["day"].as_u64()).collect();
    days.sort_unstable();
    assert_eq!(days, [0, 1, 2, 3]);

    // What CODAP asks in its turn: what is to be kept with its document.
    page.run("ask('mine', {action: 'get', resource: 'interactiveState'})");
    let begun = std::time::Instant::now();
    while page.run("return answers.length") == 0 {
        assert!(begun.elapsed().as_secs() < 20, "it is answered");
    }
    let state = json!({"success": true, "values": {"link": "mushroom?v=1&s=2&d=2&days=3"}});
    assert_eq!(page.run("return answers"), json!([["mine", state]]));

    page.in_frame(|| {
        page.run("location.hash = '#nursery/mushroom?v=1&s=3..5&d=1'");
        page.wait_for(
            "the individuals",
            "return document.querySelectorAll('#figure-list .picture[data-count]').length === 3",
        );
    });
    press(&page, ".this");
    let items = wait_for_items(&page, "clonal_mosaic_individuals", 3);
    let individuals: Vec<&Value> = items.iter().map(|item| &item["individual"]).collect();
    assert_eq!(individuals, [3, 4, 5]);
    assert_eq!(items[0]["differs"], "individual 3");
}

#[test]
fn a_document_of_codap_opens_with_what_it_showed() {
    let Some(page) = Page::start(Graphics::Neither) else { return };
    open(&page, "mushroom?v=1&d=1~codap", json!({"link": "mushroom?v=1&s=9&d=2"}));
    page.in_frame(|| {
        page.wait("what was kept", |s| s.individual == "9" && s.day == "2" && s.state == "ready");
        assert_eq!(page.link(), "mushroom?v=1&s=9&d=2~codap");
    });
}

#[test]
fn outside_of_codap_the_bar_goes_with_its_address() {
    let Some(page) = Page::open(Graphics::Neither, "#mushroom?v=1&d=1~codap") else { return };
    page.wait_for(
        "what the address is for",
        "return !!document.querySelector('#codap:not([hidden]) .told')?.textContent.includes('CODAP')",
    );
    page.run("location.hash = '#mushroom?v=1&d=2'");
    page.wait_for("the plant alone", "return document.getElementById('codap').hidden");
}
